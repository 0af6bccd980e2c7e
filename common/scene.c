// scene.c - reads a scene from an NFF file, line by line.
//
// A file may be anything: empty, truncated, binary, without an end. No line may be longer than an
// honest scene needs, so a file that is not a scene is refused after little work. Every message
// names the file and the line, and says what was expected there.
#include "common/scene.h"

#include "common/failed_check.h"

#include <errno.h>
#include <limits.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_LINE = 1000, MOST_WORDS = 16 };

typedef struct {
    FILE *file;
    const char *file_name;
    Message *message;
    Scene *scene;
    bool failed;
    long line; // the number of the current line, from 1
    char text[LONGEST_LINE + 1];
    int word_count;
    const char *words[MOST_WORDS]; // of the current line; at least one
    long view_line;                // the line of v; 0 before it
    int view_parts;                // which of its lines were there
    int cones, polygons;           // that the toolkit has no use for
} Reader;

// Writes FILE:LINE: and what is wrong into the message. Always false.
static bool wrong(Reader *reader, const char *format, ...) __attribute__((format(printf, 2, 3)));
static bool wrong(Reader *reader, const char *format, ...)
{
    Message what;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what.text, sizeof what.text, format, arguments);
    va_end(arguments);
    reader->failed = true;
    return message_set(reader->message, "%.200s:%ld: %.180s", reader->file_name, reader->line,
                       what.text);
}

// ---- lines and words --------------------------------------------------------------------------

// Reads the next line without its end. False at the end of the file, and if the line is wrong.
static bool read_line(Reader *reader)
{
    int length = 0, c;
    while ((c = getc_unlocked(reader->file)) != EOF && c != '\n') {
        if (c == '\0')
            return wrong(reader, "a zero byte: this is not text, expected an NFF scene");
        if (length == LONGEST_LINE)
            return wrong(reader, "a line of more than %d characters, expected an NFF scene",
                         LONGEST_LINE);
        reader->text[length++] = (char)c;
    }
    reader->text[length] = '\0';
    if (ferror(reader->file))
        return wrong(reader, "cannot be read: %s", strerror(errno));
    return c == '\n' || length > 0;
}

static bool is_blank(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r'); // \t \n \v \f \r
}

// Splits the line at its blanks into words, without the comment.
static bool split(Reader *reader)
{
    static const char byte_order_mark[] = "\xEF\xBB\xBF";
    char *text = reader->text;
    if (reader->line == 1 && strncmp(text, byte_order_mark, 3) == 0)
        text += 3;
    text[strcspn(text, "#")] = '\0';
    reader->word_count = 0;
    for (;;) {
        while (is_blank(*text))
            *text++ = '\0';
        if (*text == '\0')
            return true;
        if (reader->word_count == MOST_WORDS)
            return wrong(reader, "more than %d words in a line", MOST_WORDS);
        reader->words[reader->word_count++] = text;
        while (*text != '\0' && !is_blank(*text))
            text++;
    }
}

// Goes to the next line that has words. False at the end of the file, and if a line is wrong.
static bool next_line(Reader *reader)
{
    do {
        reader->line++;
        if (!read_line(reader)) {
            if (!reader->failed && reader->line > 1)
                reader->line--; // the end of the file is in its last line
            return false;
        }
        if (!split(reader))
            return false;
    } while (reader->word_count == 0);
    return true;
}

static bool read_word(Reader *reader, int index, const char *expected, double *number)
{
    const char *word = reader->words[index];
    const char *end = read_number(word, number);
    if (end == NULL || *end != '\0')
        return wrong(reader, "'%s' is not a finite number, expected %s", word_text(word).s,
                     expected);
    return true;
}

// Reads all words after the first as numbers, from least to most of them. expected is the form that
// the line should have.
static bool read_numbers(Reader *reader, const char *expected, int least, int most, double *numbers)
{
    int count = reader->word_count - 1;
    if (count < least || count > most)
        return wrong(reader, "%d numbers, expected %s", count, expected);
    for (int i = 0; i < count; i++)
        if (!read_word(reader, i + 1, expected, &numbers[i]))
            return false;
    return true;
}

// Skips lines of numbers that the toolkit has no use for. They are also checked: if one were
// missing, the next entity would be lost without a word.
static bool skip_lines(Reader *reader, int lines)
{
    char expected[80];
    double unused;
    snprintf(expected, sizeof expected, "%d lines of numbers after line %ld", lines, reader->line);
    for (int i = 0; i < lines; i++) {
        if (!next_line(reader))
            return reader->failed ? false
                                  : wrong(reader, "the end of the file, expected %s", expected);
        for (int k = 0; k < reader->word_count; k++)
            if (!read_word(reader, k, expected, &unused))
                return false;
    }
    return true;
}

// Appends an item to an array, whose room is the next power of two.
static bool append(Reader *reader, void *items, int *count, const void *item, size_t size)
{
    void **array = items;
    if ((*count & (*count - 1)) == 0) {
        void *grown = *count > INT_MAX / 2
                          ? NULL
                          : realloc(*array, (*count == 0 ? 1 : 2 * (size_t)*count) * size);
        if (grown == NULL)
            return wrong(reader, "no memory for more than %d of these", *count);
        *array = grown;
    }
    memcpy((char *)*array + (size_t)*count * size, item, size);
    (*count)++;
    return true;
}

// ---- background, lights, fills, spheres -------------------------------------------------------

static bool read_color(Reader *reader, const double *rgb, Color *color)
{
    for (int i = 0; i < 3; i++)
        if (!(rgb[i] >= 0 && rgb[i] <= 1))
            return wrong(reader, "a color of %g, expected 0 to 1", rgb[i]);
    *color = vec3_of(rgb[0], rgb[1], rgb[2]);
    return true;
}

static bool read_background(Reader *reader)
{
    double n[3];
    return read_numbers(reader, "b R G B", 3, 3, n) &&
           read_color(reader, n, &reader->scene->background);
}

// NFF leaves the brightness of a light without color to the program. Until all are counted:
static const Color not_said = {-1, -1, -1};

static bool read_light(Reader *reader)
{
    double n[6] = {0};
    Scene *scene = reader->scene;
    if (reader->word_count != 4 && reader->word_count != 7)
        return wrong(reader, "%d numbers, expected l X Y Z or l X Y Z R G B",
                     reader->word_count - 1);
    if (!read_numbers(reader, "l X Y Z [R G B]", 3, 6, n))
        return false;
    Light light = {.position = vec3_of(n[0], n[1], n[2])};
    if (!read_color(reader, n + 3, &light.color))
        return false;
    if (reader->word_count == 4)
        light.color = not_said;
    return append(reader, &scene->lights, &scene->light_count, &light, sizeof light);
}

// The more lights without a color, the darker each of them.
static void set_brightness(Scene *scene)
{
    double each = 1 / sqrt(scene->light_count);
    for (int i = 0; i < scene->light_count; i++)
        if (scene->lights[i].color[0] == not_said[0])
            scene->lights[i].color = vec3_of(each, each, each);
}

static bool append_fill(Reader *reader, Surface fill)
{
    Scene *scene = reader->scene;
    return append(reader, &scene->surfaces, &scene->surface_count, &fill, sizeof fill);
}

static bool read_fill(Reader *reader)
{
    double n[8];
    Surface fill;
    if (!read_numbers(reader, "f R G B Kd Ks Shine T IoR", 8, 8, n) ||
        !read_color(reader, n, &fill.color))
        return false;
    fill.diffuse = n[3];
    fill.specular = n[4];
    fill.shine = n[5];
    fill.transmittance = n[6];
    fill.refraction = n[7];
    return append_fill(reader, fill);
}

static bool read_sphere(Reader *reader)
{
    double n[4];
    Scene *scene = reader->scene;
    if (!read_numbers(reader, "s X Y Z RADIUS", 4, 4, n))
        return false;
    if (!(n[3] > 0))
        return wrong(reader, "a radius of %g, expected more than 0", n[3]);
    Sphere sphere = {vec3_of(n[0], n[1], n[2]), n[3], scene->surface_count - 1};
    return append(reader, &scene->spheres, &scene->sphere_count, &sphere, sizeof sphere);
}

// ---- what is left out -------------------------------------------------------------------------

static bool skip_cone(Reader *reader)
{
    reader->cones++;
    return read_numbers(reader, "c, and nothing else", 0, 0, NULL) && skip_lines(reader, 2);
}

static bool skip_polygon(Reader *reader)
{
    double vertices;
    if (!read_numbers(reader, "p or pp, then the number of vertices", 1, 1, &vertices))
        return false;
    if (vertices != floor(vertices) || vertices < 3 || vertices > INT_MAX)
        return wrong(reader, "a polygon of %g vertices, expected a whole number from 3", vertices);
    reader->polygons++;
    return skip_lines(reader, (int)vertices);
}

// ---- the viewpoint ----------------------------------------------------------------------------

static bool read_view(Reader *reader)
{
    if (reader->view_line != 0)
        return wrong(reader, "a second viewpoint, the first is in line %ld", reader->view_line);
    reader->view_line = reader->line;
    return read_numbers(reader, "v, and nothing else", 0, 0, NULL);
}

static bool read_point(Reader *reader, const char *expected, vec3 *v)
{
    double n[3];
    if (!read_numbers(reader, expected, 3, 3, n))
        return false;
    *v = vec3_of(n[0], n[1], n[2]);
    return true;
}

static bool read_from(Reader *reader)
{
    return read_point(reader, "from X Y Z", &reader->scene->view.from);
}

static bool read_at(Reader *reader)
{
    return read_point(reader, "at X Y Z", &reader->scene->view.at);
}

static bool read_up(Reader *reader)
{
    return read_point(reader, "up X Y Z", &reader->scene->view.up);
}

static bool read_angle(Reader *reader)
{
    double angle;
    if (!read_numbers(reader, "angle DEGREES", 1, 1, &angle))
        return false;
    reader->scene->view.angle = angle;
    return (angle > 0 && angle < 180) ||
           wrong(reader, "an angle of %g degrees, expected more than 0 and less than 180", angle);
}

static bool read_hither(Reader *reader)
{
    double unused;
    return read_numbers(reader, "hither DISTANCE", 1, 1, &unused);
}

static bool read_resolution(Reader *reader)
{
    double n[2];
    if (!read_numbers(reader, "resolution WIDTH HEIGHT", 2, 2, n))
        return false;
    for (int i = 0; i < 2; i++)
        if (n[i] != floor(n[i]) || n[i] < 1 || n[i] > IMAGE_MAX_SIDE)
            return wrong(reader, "a resolution of %g, expected a whole number from 1 to %d", n[i],
                         IMAGE_MAX_SIDE);
    reader->scene->view.resolution = (Resolution){(int)n[0], (int)n[1]};
    return true;
}

// What a line begins with, and what reads its numbers.
typedef struct {
    const char *word;
    bool (*read)(Reader *);
} Entity;

// The lines of a viewpoint; each must occur once, but hither may be missing.
static const Entity view_parts[] = {{"from", read_from},     {"at", read_at},
                                    {"up", read_up},         {"angle", read_angle},
                                    {"hither", read_hither}, {"resolution", read_resolution}};
enum { VIEW_PARTS = sizeof view_parts / sizeof view_parts[0] };

static bool read_view_part(Reader *reader, int i)
{
    if (reader->view_line == 0)
        return wrong(reader, "'%s' outside a viewpoint, expected 'v' before it", reader->words[0]);
    if (reader->view_parts & 1 << i)
        return wrong(reader, "a second '%s' in one viewpoint", reader->words[0]);
    reader->view_parts |= 1 << i;
    return view_parts[i].read(reader);
}

static bool view_is_complete(Reader *reader)
{
    if (reader->view_line == 0)
        return wrong(reader, "the end of the file, expected a viewpoint 'v' somewhere");
    for (int i = 0; i < VIEW_PARTS; i++) {
        if (view_parts[i].read == read_hither || (reader->view_parts & 1 << i) != 0)
            continue;
        reader->line = reader->view_line;
        return wrong(reader,
                     "a viewpoint without '%s', expected from, at, up, angle, hither and "
                     "resolution",
                     view_parts[i].word);
    }
    return true;
}

// ---- a file -----------------------------------------------------------------------------------

static bool read_entity(Reader *reader)
{
    static const Entity entities[] = {
        {"s", read_sphere}, {"f", read_fill}, {"b", read_background}, {"v", read_view},
        {"l", read_light},  {"c", skip_cone}, {"p", skip_polygon},    {"pp", skip_polygon}};
    const char *word = reader->words[0];
    for (size_t i = 0; i < sizeof entities / sizeof entities[0]; i++)
        if (strcmp(word, entities[i].word) == 0)
            return entities[i].read(reader);
    for (int i = 0; i < VIEW_PARTS; i++)
        if (strcmp(word, view_parts[i].word) == 0)
            return read_view_part(reader, i);
    return wrong(reader, "'%s', expected one of v b l f s (or c p pp, or #)", word_text(word).s);
}

static bool read_scene(Reader *reader)
{
    if (!append_fill(reader, (Surface){.color = vec3_of(1, 1, 1), .diffuse = 1}))
        return false;
    while (next_line(reader))
        if (!read_entity(reader))
            return false;
    if (reader->failed || !view_is_complete(reader))
        return false;
    set_brightness(reader->scene);
    return true;
}

bool scene_read(FILE *file, const char *name, Scene *scene, Message *message, Message *warning)
{
    *scene = (Scene){.ambient = vec3_of(SCENE_AMBIENT, SCENE_AMBIENT, SCENE_AMBIENT)};
    warning->text[0] = '\0';
    Reader reader = {.file = file, .file_name = name, .message = message, .scene = scene};
    bool good = read_scene(&reader);
    if (reader.cones > 0 || reader.polygons > 0)
        message_set(warning,
                    "%.200s: warning: left out: %d cones (c), %d polygons (p, pp); only "
                    "spheres are cast",
                    name, reader.cones, reader.polygons);
    if (!good)
        scene_free(scene);
    return good;
}

bool scene_load(const char *path, Scene *scene, Message *message)
{
    *scene = (Scene){0};
    FILE *file = fopen(path, "rb");
    if (file == NULL)
        return message_set(message, "%.200s: cannot be read: %s", path, strerror(errno));
    Message warning;
    bool good = scene_read(file, path, scene, message, &warning);
    fclose(file);
    if (good && warning.text[0] != '\0')
        fprintf(stderr, "%s\n", warning.text);
    return good;
}

const Surface *(scene_surface)(const Scene *scene, int i)
{
    if (i < 0 || i >= scene->sphere_count)
        check_failed(CHECKED_SPHERE, (long[5]){i, scene->sphere_count});
    return &scene->surfaces[scene->spheres[i].surface];
}

void scene_free(Scene *scene)
{
    free(scene->spheres);
    free(scene->surfaces);
    free(scene->lights);
    *scene = (Scene){0};
}
