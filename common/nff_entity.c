// nff_entity.c - what the lines of an NFF file mean. How they are read is nff_line.c; the
// viewpoint, nff_view.c.
#include "common/nff.h"

#include "common/large_pages.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

size_t nff_room_of(size_t count, size_t least)
{
    size_t room = 1;
    while (room < count || room < least)
        room *= 2;
    return room;
}

void *nff_room(void *items, int count, int more, size_t size, size_t least)
{
    if (more > INT_MAX - count)
        return NULL;
    size_t room = nff_room_of((size_t)count + (size_t)more, least);
    if (items != NULL && room == nff_room_of((size_t)count, least))
        return items;
    void *grown = realloc(items, room * size);
    large_pages(grown, room * size);
    return grown;
}

#define APPEND(items, count, item, least)                                                          \
    append((void **)&(items), &(count), &(item), sizeof(item), least, &reader->line)

static bool append(void **items, int *count, const void *item, size_t size, size_t least,
                   NffLine *line)
{
    void *grown = nff_room(*items, *count, 1, size, least);
    if (grown == NULL)
        return nff_wrong(line, "no memory for more than %d of these", *count);
    *items = grown;
    memcpy((char *)grown + (size_t)*count * size, item, size);
    (*count)++;
    return true;
}

// ---- colours and lights -----------------------------------------------------------------------

static bool is_brightness(double x)
{
    return x >= 0 && x <= 1;
}

static bool read_color(NffLine *line, const double *rgb, Color *color)
{
    for (int i = 0; i < 3; i++)
        if (!is_brightness(rgb[i]))
            return nff_wrong(line, "a colour of %g, expected 0 to 1", rgb[i]);
    *color = vec3_of(rgb[0], rgb[1], rgb[2]);
    return true;
}

static bool read_background(NffReader *reader)
{
    double n[3];
    return nff_numbers(&reader->line, "b R G B", 3, 3, n) &&
           read_color(&reader->line, n, &reader->scene->background);
}

// NFF leaves the brightness of a light without colour to the program. Until all are counted:
static const Color not_said = {-1, -1, -1};

static bool read_light(NffReader *reader)
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
    return APPEND(reader->scene->lights, reader->scene->light_count, light, 0);
}

// Many lights are not as much brighter as they are many.
static void set_brightness(Scene *scene)
{
    double each = 1 / sqrt(scene->light_count);
    for (int i = 0; i < scene->light_count; i++)
        if (scene->lights[i].color[0] == not_said[0])
            scene->lights[i].color = vec3_of(each, each, each);
}

// ---- spheres and their fills ------------------------------------------------------------------

bool nff_fill(const double *numbers, Surface *fill)
{
    const double *n = numbers;
    *fill = (Surface){.color = vec3_of(n[0], n[1], n[2]),
                      .diffuse = n[3],
                      .specular = n[4],
                      .shine = n[5],
                      .transmittance = n[6],
                      .refraction = n[7]};
    return is_brightness(n[0]) && is_brightness(n[1]) && is_brightness(n[2]);
}

static bool read_fill(NffReader *reader)
{
    double n[8];
    Surface fill;
    return nff_numbers(&reader->line, "f R G B Kd Ks Shine T IoR", 8, 8, n) &&
           read_color(&reader->line, n, &fill.color) && nff_fill(n, &fill) &&
           APPEND(reader->scene->surfaces, reader->scene->surface_count, fill, 0);
}

bool nff_sphere(const double *numbers, int surface, Sphere *sphere)
{
    *sphere = (Sphere){vec3_of(numbers[0], numbers[1], numbers[2]), numbers[3], surface};
    return sphere->radius > 0;
}

static bool read_sphere(NffReader *reader)
{
    double n[4];
    Sphere sphere;
    if (!nff_numbers(&reader->line, "s X Y Z RADIUS", 4, 4, n))
        return false;
    if (!nff_sphere(n, reader->scene->surface_count - 1, &sphere))
        return nff_wrong(&reader->line, "a radius of %g, expected more than 0", n[3]);
    return APPEND(reader->scene->spheres, reader->scene->sphere_count, sphere,
                  reader->least_spheres);
}

// ---- what is left out -------------------------------------------------------------------------

static bool skip_cone(NffReader *reader)
{
    reader->cones++;
    return nff_numbers(&reader->line, "c, and nothing else", 0, 0, NULL) &&
           nff_skip(&reader->line, 2);
}

static bool skip_polygon(NffReader *reader)
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

// ---- line after line --------------------------------------------------------------------------

static bool read_entity(NffReader *reader)
{
    static const struct {
        const char *word;
        bool (*read)(NffReader *);
    } entities[] = {{"s", read_sphere},  {"f", read_fill},    {"b", read_background},
                    {"v", nff_view},     {"l", read_light},   {"c", skip_cone},
                    {"p", skip_polygon}, {"pp", skip_polygon}};
    const char *word = reader->line.words[0];
    for (size_t i = 0; i < sizeof entities / sizeof entities[0]; i++)
        if (strcmp(word, entities[i].word) == 0)
            return entities[i].read(reader);
    int part = nff_view_part(word);
    if (part != 0)
        return nff_read_view_part(reader, part);
    return nff_wrong(&reader->line, "'%s', expected one of v b l f s (or c p pp, or #)",
                     word_text(word).s);
}

static bool read_entities(NffReader *reader)
{
    while (nff_plain_lines(reader)) {
        if (!nff_next(&reader->line))
            return !reader->line.failed;
        if (!read_entity(reader))
            return false;
    }
    return false;
}

// A large array that need not grow is in large pages from its first sphere to its last. Memory that
// is not used costs nothing, so lines may be longer; if they are shorter, the array grows.
static size_t spheres_expected(off_t file_size)
{
    enum { USUAL_LINE = 64, MOST = 1 << 22 };
    off_t count = file_size / USUAL_LINE;
    return (size_t)(count < MOST ? count : MOST);
}

static off_t size_of(FILE *file)
{
    struct stat status;
    return fstat(fileno(file), &status) == 0 && S_ISREG(status.st_mode) ? status.st_size : 0;
}

bool nff_entities(NffReader *reader)
{
    Scene *scene = reader->scene;
    reader->file_size = size_of(reader->line.file);
    reader->least_spheres = spheres_expected(reader->file_size);
    const Surface white = {.color = vec3_of(1, 1, 1), .diffuse = 1};
    if (!APPEND(scene->surfaces, scene->surface_count, white, 0) || !read_entities(reader))
        return false;
    set_brightness(scene);
    return true;
}
