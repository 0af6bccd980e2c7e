// numbers.c - a message, as a list of numbers.
#include "tests/judge/numbers.h"

#include "common/camera.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

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
    size_t bytes = (size_t)numbers->count * sizeof *numbers->at;
    Numbers copy = {numbers->count, numbers->count, malloc(bytes + 1)};
    if (copy.at == NULL)
        abort();
    if (bytes > 0)
        memcpy(copy.at, numbers->at, bytes);
    return copy;
}

bool numbers_same(const Numbers *a, const Numbers *b)
{
    bool same = a->count == b->count;
    for (int i = 0; same && i < a->count; i++)
        same = same_double(a->at[i], b->at[i]);
    return same;
}

bool has_reasons(int exercise)
{
    return strcmp(exercises[exercise].results, "CameraFault Camera") == 0;
}

int reasons_in(const Numbers *numbers)
{
    double fault = numbers->count > 0 ? numbers->at[0] : -1;
    if (fault != floor(fault))
        return (int)fault;
    return fault >= 0 && fault < CAMERA_FAULTS ? 1 << (int)fault : 0;
}

void set_reasons(Numbers *numbers, int reasons)
{
    int first = 0;
    while ((reasons >> first & 1) == 0)
        first++;
    numbers->at[0] = reasons == 1 << first ? first : reasons + 0.5;
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

static void walk_value(void *context, const char *name, void *at, size_t size, bool is_double)
{
    Walk *walk = context;
    double x;
    (void)name;
    if (is_double) {
        memcpy(&x, at, sizeof x);
        x = walk_number(walk, x);
        memcpy(at, &x, sizeof x);
    } else if (size == sizeof(char)) {
        *(char *)at = (char)lrint(walk_number(walk, *(char *)at));
    } else {
        int i;
        memcpy(&i, at, sizeof i);
        i = (int)lrint(walk_number(walk, i));
        memcpy(at, &i, sizeof i);
    }
}

static void walk_flat(Walk *walk, const Type *type, void *value)
{
    memset(value, 0, type->size);
    if (!walk->writing)
        wire_get_value(walk->wire, type, value);
    type_visit(type, "", value, walk_value, walk);
    if (walk->writing)
        wire_put_value(walk->wire, type, value);
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

// The items are not kept, only the value that is flat.
static void walk_type(Walk *walk, const Type *type)
{
    _Alignas(32) unsigned char value[TYPE_MOST_BYTES];
    if (type_is_flat(type)) {
        walk_flat(walk, type, value);
        if (type == &type_Resolution)
            memcpy(walk->size, value, sizeof *walk->size);
        return;
    }
    for (const Field *field = type->fields; field < type->fields + type->count; field++) {
        int count = 0;
        if (field->kind == FIELD_OF_ONE)
            walk_type(walk, field->type);
        else if (field->kind == FIELD_OF_PIXELS)
            walk_pixels(walk);
        else
            walk_flat(walk, &type_int, &count);
        for (int i = 0; i < count && !walk->bad && !walk->wire->bad; i++)
            walk_type(walk, field->type);
    }
}

static void walk_word(Walk *walk, const char *name)
{
    const Type *type = type_named(name);
    if (type != NULL)
        walk_type(walk, type);
    else if (strcmp(name, "Pixels") == 0)
        walk_pixels(walk);
    else if (strcmp(name, "Doubles") == 0)
        for (int i = walk->size->width * walk->size->height; i > 0; i--)
            walk_type(walk, &type_double);
    else {
        fprintf(stderr, "tests/judge/types.def has no type %s\n", name);
        abort();
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

// The name of the field that a number belongs to, or NULL after the last; and how many there are.
typedef struct {
    int place, count;
    const char *name;
} Find;

static void find_number(void *context, const char *name, void *at, size_t size, bool is_double)
{
    Find *find = context;
    (void)at, (void)size, (void)is_double;
    if (find->count++ == find->place)
        find->name = name;
}

static const char *find_place(const char *words, int place, int *count)
{
    char name[32];
    int used = 0;
    Find find = {place, 0, NULL};
    for (; sscanf(words, " %31s%n", name, &used) == 1; words += used) {
        _Alignas(32) unsigned char value[TYPE_MOST_BYTES] = {0};
        const Type *type = type_named(name);
        if (type != NULL && type_is_flat(type))
            type_visit(type, "", value, find_number, &find);
    }
    *count = find.count;
    return find.name;
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

bool layout_is_step(const Exercise *exercise)
{
    return strcmp(exercise->arguments, "Sphere vec3 vec3") == 0 &&
           strcmp(exercise->results, "vec3") == 0;
}

// If there are fewer roots, the values of the unused t do not matter.
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

// ---- do two numbers agree? ---------------------------------------------------------------------

bool same_double(double a, double b)
{
    return same_within(a, b, 1e-9);
}

bool same_within(double a, double b, double tolerance)
{
    if (isnan(a) || isnan(b))
        return isnan(a) && isnan(b);
    if (isinf(a) || isinf(b))
        return a == b;
    return a == b || fabs(a - b) <= tolerance * (1 + fmin(fabs(a), fabs(b)));
}
