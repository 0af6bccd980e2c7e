// scene.c - what the lines of an NFF file mean. How they are read is nff_line.c.
#include "common/scene.h"

#include "common/nff_line.h"

#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

// The lines of a viewpoint, each of which must stand once.
enum { FROM = 1, AT = 2, UP = 4, ANGLE = 8, HITHER = 16, RESOLUTION = 32 };
static const struct {
    const char *word;
    int part;
} view_parts[] = {{"from", FROM},   {"at", AT},         {"up", UP},
                  {"angle", ANGLE}, {"hither", HITHER}, {"resolution", RESOLUTION}};
enum { VIEW_PARTS = sizeof view_parts / sizeof view_parts[0] };

typedef struct {
    NffLine line;
    Scene *scene;
    int view_line;       // where v stands; 0 before it
    int view_parts;      // which of its lines were there
    int cones, polygons; // that the toolkit has no use for
} Reader;

// Room for one more behind count items: the array doubles whenever it is full.
static void *room_for_one(void *items, int count, size_t size)
{
    if (count != 0 && (count & (count - 1)) != 0)
        return items;
    if (count > INT_MAX / 2)
        return NULL;
    return realloc(items, size * (count == 0 ? 1 : 2 * (size_t)count));
}

#define APPEND(items, count, item)                                                                 \
    append((void **)&(items), &(count), &(item), sizeof(item), &reader->line)

static bool append(void **items, int *count, const void *item, size_t size, NffLine *line)
{
    void *grown = room_for_one(*items, *count, size);
    if (grown == NULL)
        return nff_wrong(line, "no memory for more than %d of these", *count);
    *items = grown;
    memcpy((char *)grown + (size_t)*count * size, item, size);
    (*count)++;
    return true;
}

static bool read_color(NffLine *line, const double *rgb, Color *color)
{
    for (int i = 0; i < 3; i++)
        if (rgb[i] < 0 || rgb[i] > 1)
            return nff_wrong(line, "a colour of %g, expected 0 to 1", rgb[i]);
    *color = vec3_of(rgb[0], rgb[1], rgb[2]);
    return true;
}

static bool read_background(Reader *reader)
{
    double n[3];
    return nff_numbers(&reader->line, "b R G B", 3, 3, n) &&
           read_color(&reader->line, n, &reader->scene->background);
}

static bool read_viewpoint(Reader *reader)
{
    if (reader->view_line != 0)
        return nff_wrong(&reader->line, "a second viewpoint, the first is in line %d",
                         reader->view_line);
    reader->view_line = reader->line.number;
    return nff_numbers(&reader->line, "v, and nothing else", 0, 0, NULL);
}

static bool read_angle(NffLine *line, double *angle)
{
    if (!nff_numbers(line, "angle DEGREES", 1, 1, angle))
        return false;
    if (*angle <= 0 || *angle >= 180)
        return nff_wrong(line, "an angle of %g degrees, expected more than 0 and less than 180",
                         *angle);
    return true;
}

static bool read_resolution(NffLine *line, Resolution *size)
{
    double n[2];
    if (!nff_numbers(line, "resolution WIDTH HEIGHT", 2, 2, n))
        return false;
    for (int i = 0; i < 2; i++)
        if (n[i] != floor(n[i]) || n[i] < 1 || n[i] > IMAGE_MAX_SIDE)
            return nff_wrong(line, "a resolution of %g, expected a whole number from 1 to %d", n[i],
                             IMAGE_MAX_SIDE);
    *size = (Resolution){(int)n[0], (int)n[1]};
    return true;
}

static bool read_view_part(Reader *reader, int part)
{
    Viewpoint *view = &reader->scene->view;
    NffLine *line = &reader->line;
    if (reader->view_line == 0)
        return nff_wrong(line, "'%s' outside a viewpoint, expected 'v' before it", line->words[0]);
    if (reader->view_parts & part)
        return nff_wrong(line, "a second '%s' in one viewpoint", line->words[0]);
    reader->view_parts |= part;
    double hither;
    switch (part) {
    case FROM:
        return nff_vec3(line, "from X Y Z", &view->from);
    case AT:
        return nff_vec3(line, "at X Y Z", &view->at);
    case UP:
        return nff_vec3(line, "up X Y Z", &view->up);
    case ANGLE:
        return read_angle(line, &view->angle);
    case RESOLUTION:
        return read_resolution(line, &view->resolution);
    default:
        return nff_numbers(line, "hither DISTANCE", 1, 1, &hither);
    }
}

// NFF leaves the brightness of a light without colour to the program. Until all are counted:
static const Color not_said = {-1, -1, -1};

static bool read_light(Reader *reader)
{
    double n[6] = {0};
    NffLine *line = &reader->line;
    if (line->word_count != 4 && line->word_count != 7)
        return nff_wrong(line, "%d numbers, expected l X Y Z or l X Y Z R G B",
                         line->word_count - 1);
    if (!nff_numbers(line, "l X Y Z [R G B]", 3, 6, n))
        return false;
    Light light = {.position = vec3_of(n[0], n[1], n[2])};
    if (!read_color(line, n + 3, &light.color))
        return false;
    if (line->word_count == 4)
        light.color = not_said;
    return APPEND(reader->scene->lights, reader->scene->light_count, light);
}

static bool read_fill(Reader *reader)
{
    double n[8];
    Surface fill;
    if (!nff_numbers(&reader->line, "f R G B Kd Ks Shine T IoR", 8, 8, n) ||
        !read_color(&reader->line, n, &fill.color))
        return false;
    fill.diffuse = n[3];
    fill.specular = n[4];
    fill.shine = n[5];
    fill.transmittance = n[6];
    fill.refraction = n[7];
    return APPEND(reader->scene->surfaces, reader->scene->surface_count, fill);
}

static bool add_sphere(Reader *reader, const double *n)
{
    if (n[3] <= 0)
        return nff_wrong(&reader->line, "a radius of %g, expected more than 0", n[3]);
    Sphere sphere = {vec3_of(n[0], n[1], n[2]), n[3], reader->scene->surface_count - 1};
    return APPEND(reader->scene->spheres, reader->scene->sphere_count, sphere);
}

static bool read_sphere(Reader *reader)
{
    double n[4];
    return nff_numbers(&reader->line, "s X Y Z RADIUS", 4, 4, n) && add_sphere(reader, n);
}

static bool skip_cone(Reader *reader)
{
    reader->cones++;
    return nff_numbers(&reader->line, "c, and nothing else", 0, 0, NULL) &&
           nff_skip(&reader->line, 2);
}

static bool skip_polygon(Reader *reader)
{
    double vertices;
    NffLine *line = &reader->line;
    if (!nff_numbers(line, "p or pp, then the number of vertices", 1, 1, &vertices))
        return false;
    if (vertices != floor(vertices) || vertices < 3 || vertices > INT_MAX)
        return nff_wrong(line, "a polygon of %g vertices, expected a whole number from 3",
                         vertices);
    reader->polygons++;
    return nff_skip(line, (int)vertices);
}

static bool read_entity(Reader *reader)
{
    static const struct {
        const char *word;
        bool (*read)(Reader *);
    } entities[] = {{"s", read_sphere},    {"f", read_fill},    {"b", read_background},
                    {"v", read_viewpoint}, {"l", read_light},   {"c", skip_cone},
                    {"p", skip_polygon},   {"pp", skip_polygon}};
    const char *word = reader->line.words[0];
    for (size_t i = 0; i < sizeof entities / sizeof entities[0]; i++)
        if (strcmp(word, entities[i].word) == 0)
            return entities[i].read(reader);
    for (int i = 0; i < VIEW_PARTS; i++)
        if (strcmp(word, view_parts[i].word) == 0)
            return read_view_part(reader, view_parts[i].part);
    return nff_wrong(&reader->line, "'%s', expected one of v b l f s (or c p pp, or #)",
                     word_text(word).s);
}

static bool read_entities(Reader *reader)
{
    double n[4];
    for (;;)
        if (nff_plain(&reader->line, 's', 4, n)) {
            if (!add_sphere(reader, n))
                return false;
        } else {
            if (!nff_next(&reader->line))
                return true;
            if (!read_entity(reader))
                return false;
        }
}

static bool is_complete(Reader *reader)
{
    NffLine *line = &reader->line;
    if (reader->view_line == 0)
        return nff_wrong(line, "the end of the file, expected a viewpoint 'v' somewhere");
    for (int i = 0; i < VIEW_PARTS; i++) {
        if (view_parts[i].part == HITHER || (reader->view_parts & view_parts[i].part) != 0)
            continue;
        line->number = reader->view_line;
        return nff_wrong(line,
                         "a viewpoint without '%s', expected from, at, up, angle, "
                         "hither and resolution",
                         view_parts[i].word);
    }
    return true;
}

// Many lights are not as much brighter as they are many.
static void set_brightness(Scene *scene)
{
    double each = 1 / sqrt(scene->light_count);
    for (int i = 0; i < scene->light_count; i++)
        if (scene->lights[i].color[0] == not_said[0])
            scene->lights[i].color = vec3_of(each, each, each);
}

static void warn_of_left_out(const Reader *reader, Message *warning)
{
    if (reader->cones > 0 || reader->polygons > 0)
        message_set(warning,
                    "%.200s: warning: left out: %d cones (c), %d polygons (p, pp); only "
                    "spheres are cast",
                    reader->line.file_name, reader->cones, reader->polygons);
}

bool scene_read(FILE *file, const char *name, Scene *scene, Message *message, Message *warning)
{
    *scene = (Scene){0};
    warning->text[0] = '\0';
    Reader *reader = calloc(1, sizeof *reader);
    if (reader == NULL)
        return message_set(message, "%.200s: no memory to read it", name);
    reader->scene = scene;
    nff_begin(&reader->line, file, name, message);

    const Surface white = {.color = vec3_of(1, 1, 1), .diffuse = 1};
    bool good = APPEND(scene->surfaces, scene->surface_count, white);
    good = good && read_entities(reader) && !reader->line.failed && is_complete(reader);
    scene->ambient = vec3_of(SCENE_AMBIENT, SCENE_AMBIENT, SCENE_AMBIENT);
    set_brightness(scene);
    warn_of_left_out(reader, warning);
    if (!good)
        scene_free(scene);
    free(reader);
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

void scene_free(Scene *scene)
{
    free(scene->spheres);
    free(scene->surfaces);
    free(scene->lights);
    *scene = (Scene){0};
}
