// layout.c - what crosses the pipe, as a list of numbers.
#include "tests/told/layout.h"

#include "common/ray.h"
#include "common/screen.h"
#include "exercises/05-quadratic.h"
#include "tests/judge/same.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MOST_FIELDS = 8, MOST_BYTES = 256 };

// Where the numbers of a type lie: v a vec3, d a double, i an int.
typedef struct {
    const char *name;
    size_t size;
    struct {
        size_t offset;
        char kind;
        const char *name;
    } fields[MOST_FIELDS];
} Type;

#define TYPE(type) #type, sizeof(type)
#define V(type, field)                                                                             \
    {                                                                                              \
        offsetof(type, field), 'v', #field                                                         \
    }
#define D(type, field)                                                                             \
    {                                                                                              \
        offsetof(type, field), 'd', #field                                                         \
    }
#define I(type, field)                                                                             \
    {                                                                                              \
        offsetof(type, field), 'i', #field                                                         \
    }

// clang-format off
static const Type types[] = {
    {TYPE(double), {{0, 'd', ""}}},
    {TYPE(int), {{0, 'i', ""}}},
    {TYPE(vec3), {{0, 'v', ""}}},
    {TYPE(CameraFault), {{0, 'i', ""}}},
    {TYPE(Handedness), {{0, 'i', ""}}},
    {TYPE(Resolution), {I(Resolution, width), I(Resolution, height)}},
    {TYPE(Pixel), {I(Pixel, column), I(Pixel, row)}},
    {TYPE(ScreenPoint), {D(ScreenPoint, x), D(ScreenPoint, y)}},
    {TYPE(Normalized), {D(Normalized, s), D(Normalized, t)}},
    {TYPE(Ray), {V(Ray, origin), V(Ray, direction)}},
    {TYPE(Sphere), {V(Sphere, center), D(Sphere, radius), I(Sphere, surface)}},
    {TYPE(Hit), {D(Hit, t), I(Hit, sphere)}},
    {TYPE(Quadratic), {D(Quadratic, a), D(Quadratic, b), D(Quadratic, c)}},
    {TYPE(Roots), {I(Roots, count), D(Roots, t[0]), D(Roots, t[1])}},
    {TYPE(Camera), {V(Camera, origin), V(Camera, right), V(Camera, up), V(Camera, forward),
                    D(Camera, distance), D(Camera, width), D(Camera, height)}},
    {TYPE(LookAt), {V(LookAt, eye), V(LookAt, at), V(LookAt, up), D(LookAt, width),
                    D(LookAt, aspect)}},
    {TYPE(Corners), {V(Corners, upper_left), V(Corners, upper_right), V(Corners, lower_left),
                     V(Corners, lower_right)}},
    {TYPE(Viewpoint), {V(Viewpoint, from), V(Viewpoint, at), V(Viewpoint, up), D(Viewpoint, angle),
                       I(Viewpoint, resolution.width), I(Viewpoint, resolution.height)}},
    {TYPE(Light), {V(Light, position), V(Light, color), I(Light, kind)}},
    {TYPE(Surface), {V(Surface, color), D(Surface, diffuse), D(Surface, specular),
                     D(Surface, shine), D(Surface, transmittance), D(Surface, refraction)}},
};
// clang-format on

void numbers_add(Numbers *numbers, double x)
{
    if (numbers->count == numbers->room) {
        numbers->room = 2 * numbers->room + 16;
        numbers->at = realloc(numbers->at, (size_t)numbers->room * sizeof *numbers->at);
        if (numbers->at == NULL)
            abort();
    }
    numbers->at[numbers->count++] = x;
}

void numbers_free(Numbers *numbers)
{
    free(numbers->at);
    *numbers = (Numbers){0};
}

Numbers numbers_copy(const Numbers *numbers)
{
    Numbers copy = {0};
    for (int i = 0; i < numbers->count; i++)
        numbers_add(&copy, numbers->at[i]);
    return copy;
}

bool numbers_same(const Numbers *a, const Numbers *b)
{
    bool same = a->count == b->count;
    for (int i = 0; same && i < a->count; i++)
        same = same_double(a->at[i], b->at[i]);
    return same;
}

// One way or the other through a message and its numbers.
typedef struct {
    Wire *wire;
    bool writing; // the message, from numbers
    Numbers *into;
    const Numbers *from;
    int next;
    Resolution *size;
    bool bad;
} Walk;

static double walk_number(Walk *walk, double x)
{
    if (!walk->writing) {
        numbers_add(walk->into, x);
        return x;
    }
    if (walk->next >= walk->from->count) {
        walk->bad = true;
        return 0;
    }
    return walk->from->at[walk->next++];
}

static void walk_int(Walk *walk, unsigned char *at)
{
    int i;
    memcpy(&i, at, sizeof i);
    i = (int)lrint(walk_number(walk, i));
    memcpy(at, &i, sizeof i);
}

static void walk_doubles(Walk *walk, unsigned char *at, int count)
{
    for (double d; count-- > 0; at += sizeof d) {
        memcpy(&d, at, sizeof d);
        d = walk_number(walk, d);
        memcpy(at, &d, sizeof d);
    }
}

static const Type *type_of(const char *name)
{
    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++)
        if (strcmp(types[i].name, name) == 0 && types[i].size <= MOST_BYTES)
            return &types[i];
    return NULL;
}

static void walk_type(Walk *walk, const char *name, void *value)
{
    unsigned char bytes[MOST_BYTES] = {0};
    const Type *type = type_of(name);
    if (type == NULL) {
        fprintf(stderr, "tests/told/layout.c does not know the type %s\n", name);
        abort();
    }
    if (!walk->writing)
        wire_get(walk->wire, bytes, type->size);
    for (int k = 0; k < MOST_FIELDS && type->fields[k].kind != '\0'; k++) {
        unsigned char *at = bytes + type->fields[k].offset;
        if (type->fields[k].kind == 'i')
            walk_int(walk, at);
        else
            walk_doubles(walk, at, type->fields[k].kind == 'v' ? 3 : 1);
    }
    if (walk->writing)
        wire_put(walk->wire, bytes, type->size);
    if (value != NULL)
        memcpy(value, bytes, type->size);
}

static void walk_items(Walk *walk, const char *name)
{
    int count = 0;
    walk_type(walk, "int", &count);
    for (int i = 0; i < count && !walk->bad && !walk->wire->bad; i++)
        walk_type(walk, name, NULL);
}

static void walk_pixels(Walk *walk)
{
    for (size_t i = 3 * (size_t)walk->size->width * (size_t)walk->size->height; i > 0; i--) {
        uint8_t byte = 0;
        if (!walk->writing)
            wire_get(walk->wire, &byte, 1);
        byte = (uint8_t)lrint(walk_number(walk, byte));
        if (walk->writing)
            wire_put(walk->wire, &byte, 1);
    }
}

static void walk_word(Walk *walk, const char *name)
{
    if (strcmp(name, "Scene") == 0) {
        walk_type(walk, "Viewpoint", NULL);
        walk_type(walk, "vec3", NULL);
        walk_type(walk, "vec3", NULL);
        walk_items(walk, "Sphere");
        walk_items(walk, "Surface");
        walk_items(walk, "Light");
    } else if (strcmp(name, "Image") == 0) {
        walk_type(walk, "Resolution", walk->size);
        walk_pixels(walk);
    } else if (strcmp(name, "Pixels") == 0) {
        walk_pixels(walk);
    } else if (strcmp(name, "Doubles") == 0) {
        for (int i = walk->size->width * walk->size->height; i > 0; i--)
            walk_type(walk, "double", NULL);
    } else {
        walk_type(walk, name, NULL);
    }
}

static bool walk_words(Walk *walk, const char *words)
{
    char name[32];
    int used = 0;
    for (; sscanf(words, " %31s%n", name, &used) == 1; words += used)
        walk_word(walk, name);
    return !walk->bad && !walk->wire->bad;
}

// The name of the field that a number belongs to, or NULL beyond the last; and how many there are.
static const char *find_place(const char *words, int place, int *count)
{
    char name[32];
    int used = 0;
    *count = 0;
    for (; sscanf(words, " %31s%n", name, &used) == 1; words += used) {
        const Type *type = type_of(name);
        for (int k = 0; type != NULL && k < MOST_FIELDS && type->fields[k].kind != '\0'; k++) {
            *count += type->fields[k].kind == 'v' ? 3 : 1;
            if (place >= 0 && place < *count)
                return type->fields[k].name;
        }
    }
    return NULL;
}

int layout_places(const char *words)
{
    int count;
    find_place(words, -1, &count);
    return count;
}

const char *layout_place(const char *words, int place)
{
    int count;
    const char *name = find_place(words, place, &count);
    return name == NULL ? "" : name;
}

bool layout_is_step(const Layout *layout)
{
    return strcmp(layout->arguments, "Sphere vec3 vec3") == 0 &&
           strcmp(layout->results, "vec3") == 0;
}

// Where there are fewer roots, the t that are none do not matter.
static void clear_what_is_no_root(double *roots)
{
    for (int i = 0; i < 2; i++)
        if (!(i < roots[0]))
            roots[1 + i] = 0;
}

bool layout_read(const char *words, Wire *wire, Resolution *size, Numbers *numbers)
{
    numbers->count = 0;
    Walk walk = {.wire = wire, .into = numbers, .size = size};
    bool good = walk_words(&walk, words);
    if (strcmp(words, "Roots") == 0)
        clear_what_is_no_root(numbers->at);
    return good;
}

bool layout_write(const char *words, const Numbers *numbers, Resolution *size, Wire *wire)
{
    Walk walk = {.wire = wire, .writing = true, .from = numbers, .size = size};
    return walk_words(&walk, words) && walk.next == numbers->count;
}
