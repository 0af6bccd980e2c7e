// numbers.c - the numbers of a call.
#include "tests/judge/numbers.h"

#include "common/camera.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MOST_NUMBERS = 8 << 20 };

bool numbers_make_room(Numbers *numbers, uint64_t count)
{
    if (count > MOST_NUMBERS)
        return false;
    if (count <= (uint64_t)numbers->room && numbers->at != NULL)
        return true;
    int room = 2 * (int)count + 16;
    double *at = realloc(numbers->at, (size_t)room * sizeof *at);
    if (at == NULL)
        return false;
    numbers->at = at;
    numbers->room = room;
    return true;
}

void numbers_add(Numbers *numbers, double x)
{
    if (!numbers_make_room(numbers, (uint64_t)numbers->count + 1))
        abort();
    numbers->at[numbers->count++] = x;
}

void numbers_add_all(Numbers *numbers, const Numbers *others)
{
    if (!numbers_make_room(numbers, (uint64_t)numbers->count + (uint64_t)others->count))
        abort();
    if (others->count > 0)
        memcpy(numbers->at + numbers->count, others->at, (size_t)others->count * sizeof(double));
    numbers->count += others->count;
}

void numbers_clear(Numbers *numbers)
{
    numbers->count = numbers->read = 0;
    numbers->bad = numbers->is_hostile = numbers->overran = false;
}

void numbers_free(Numbers *numbers)
{
    free(numbers->at);
    *numbers = (Numbers){0};
}

Numbers numbers_copy(const Numbers *numbers)
{
    Numbers copy = {0};
    numbers_add_all(&copy, numbers);
    return copy;
}

bool numbers_are_read(const Numbers *numbers)
{
    return !numbers->bad && numbers->read == numbers->count;
}

Numbers numbers_again(const Numbers *numbers)
{
    return (Numbers){.count = numbers->count, .at = numbers->at};
}

// ---- values ------------------------------------------------------------------------------------

static size_t pixels_of(const Image *image)
{
    return (size_t)image->size.width * (size_t)image->size.height;
}

// Of a field that has several.
static char *items_of(const Field *field, const void *value)
{
    char *items;
    memcpy(&items, (const char *)value + field->offset, sizeof items);
    return items;
}

static void put_number(void *numbers, const char *name, void *at, size_t size, bool is_double)
{
    double x;
    int i;
    (void)name;
    if (is_double)
        memcpy(&x, at, sizeof x);
    else if (size == sizeof(char))
        x = *(char *)at;
    else
        x = *(int *)memcpy(&i, at, sizeof i);
    numbers_add(numbers, x);
}

void numbers_put(Numbers *numbers, const Type *type, const void *value)
{
    if (type_is_flat(type)) {
        type_visit(type, "", (void *)value, put_number, numbers);
        return;
    }
    for (const Field *field = type->fields; field < type->fields + type->count; field++) {
        if (field->kind == FIELD_OF_ONE)
            numbers_put(numbers, field->type, (const char *)value + field->offset);
        if (field->kind == FIELD_OF_PIXELS)
            numbers_put_pixels(numbers, value);
        if (field->kind == FIELD_OF_LIST) {
            int count;
            memcpy(&count, (const char *)value + field->count_at, sizeof count);
            numbers_add(numbers, count);
            for (int i = 0; i < count; i++)
                numbers_put(numbers, field->type,
                            items_of(field, value) + (size_t)i * field->type->size);
        }
    }
}

// If there is none: the impossible, as of a blank.
static double get_number(Numbers *numbers)
{
    numbers->bad = numbers->bad || numbers->read >= numbers->count;
    return numbers->bad ? NAN : numbers->at[numbers->read++];
}

static int get_whole(Numbers *numbers, int low, int high)
{
    double x = get_number(numbers);
    if (x >= low && x <= high && x == floor(x))
        return (int)x;
    numbers->bad = true;
    return -1;
}

static void get_one(void *numbers, const char *name, void *at, size_t size, bool is_double)
{
    (void)name;
    if (is_double) {
        double x = get_number(numbers);
        memcpy(at, &x, sizeof x);
    } else if (size == sizeof(char)) {
        *(char *)at = (char)get_whole(numbers, CHAR_MIN, CHAR_MAX);
    } else {
        int i = get_whole(numbers, INT_MIN, INT_MAX);
        memcpy(at, &i, sizeof i);
    }
}

static const void *guard_of(const Type *type)
{
    static Sphere sphere;
    static Light light;
    static const Surface surface = {{0.93, 0.07, 0.91}, 0.5, 0.5, 10, 0, 1};
    static const unsigned char zeros[TYPE_MOST_BYTES];
    sphere = GUARD_SPHERE;
    light = GUARD_LIGHT;
    return type == &type_Sphere    ? (const void *)&sphere
           : type == &type_Light   ? (const void *)&light
           : type == &type_Surface ? (const void *)&surface
                                   : zeros;
}

static void get_list(Numbers *numbers, const Field *field, void *value)
{
    // Each item has one number at least.
    int count = get_whole(numbers, 0, numbers->count - numbers->read);
    size_t size = field->type->size;
    char *items = count >= 0 ? malloc(((size_t)count + 2) * size) : NULL;
    if (items == NULL) {
        numbers->bad = true;
        count = 0;
    } else {
        memcpy(items, guard_of(field->type), size);
        items += size;
    }
    memcpy((char *)value + field->offset, &items, sizeof items);
    memcpy((char *)value + field->count_at, &count, sizeof count);
    for (int i = 0; i < count; i++)
        numbers_get(numbers, field->type, items + (size_t)i * size);
    if (items != NULL)
        memcpy(items + (size_t)count * size, guard_of(field->type), size);
}

#define GUARD_DEPTH 1.2345678901234567e300
enum { PIXEL_GUARD = 3 * 64, GUARD_BYTE = 0xa6 };

static void get_image(Numbers *numbers, Image *image)
{
    Message message;
    Resolution size = image->size;
    // A picture that is not there would be read from memory that is not there.
    bool is_there = !numbers->bad && size.width > 0 && size.height > 0 &&
                    (int64_t)size.width * size.height <= (numbers->count - numbers->read) / 3;
    if (!is_there || !image_create(image, size, &message)) {
        *image = (Image){0};
        numbers->bad = true;
        return;
    }
    uint8_t *rgb = realloc(image->rgb, 3 * pixels_of(image) + PIXEL_GUARD);
    if (rgb == NULL) {
        image_free(image);
        numbers->bad = true;
        return;
    }
    image->rgb = rgb;
    memset(rgb + 3 * pixels_of(image), GUARD_BYTE, PIXEL_GUARD);
    numbers_get_pixels(numbers, image);
}

bool is_light_kind(LightKind kind)
{
    return kind == LIGHT_POINT || kind == LIGHT_DISTANT;
}

static bool is_sane(const Numbers *numbers, const Scene *scene)
{
    bool sane = true;
    for (int i = 0; i < scene->sphere_count; i++)
        sane = sane && scene->spheres[i].surface >= 0 &&
               scene->spheres[i].surface < scene->surface_count;
    for (int i = 0; i < scene->light_count; i++)
        sane = sane && (!numbers->is_hostile || is_light_kind(scene->lights[i].kind));
    return sane;
}

static int padding = 0xff;

void numbers_fill_padding_with(int byte)
{
    padding = byte;
}

void numbers_get(Numbers *numbers, const Type *type, void *value)
{
    if (type->size > 0)
        memset(value, padding, type->size);
    if (type_is_flat(type)) {
        type_visit(type, "", value, get_one, numbers);
        return;
    }
    for (const Field *field = type->fields; field < type->fields + type->count; field++) {
        if (field->kind == FIELD_OF_ONE)
            numbers_get(numbers, field->type, (char *)value + field->offset);
        if (field->kind == FIELD_OF_PIXELS)
            get_image(numbers, value);
        if (field->kind == FIELD_OF_LIST)
            get_list(numbers, field, value);
    }
    if (type == &type_Scene && !is_sane(numbers, value))
        numbers->bad = true;
}

void numbers_free_value(const Type *type, void *value)
{
    for (int i = 0; type->kind == TYPE_OF_FIELDS && i < type->count; i++) {
        const Field *field = &type->fields[i];
        if (field->kind == FIELD_OF_ONE)
            continue;
        char *items = items_of(field, value);
        if (items != NULL && field->kind == FIELD_OF_LIST)
            items -= field->type->size; // the guard before the first
        free(items);
    }
}

void numbers_put_pixels(Numbers *numbers, const Image *image)
{
    for (size_t i = 0; i < 3 * pixels_of(image); i++)
        numbers_add(numbers, image->rgb[i]);
}

void numbers_get_pixels(Numbers *numbers, Image *image)
{
    for (size_t i = 0; i < 3 * pixels_of(image); i++)
        image->rgb[i] = (uint8_t)get_whole(numbers, 0, UINT8_MAX);
}

bool pixels_overran(const Image *image)
{
    const uint8_t *guard = image->rgb + 3 * pixels_of(image);
    for (size_t i = 0; i < PIXEL_GUARD; i++)
        if (guard[i] != GUARD_BYTE)
            return true;
    return false;
}

void numbers_put_doubles(Numbers *numbers, const double *doubles, const Image *image)
{
    for (size_t i = 0; i < pixels_of(image); i++)
        numbers_add(numbers, doubles[i]);
}

void numbers_get_into_doubles(Numbers *numbers, double *doubles, const Image *image)
{
    for (size_t i = 0; i < pixels_of(image); i++)
        doubles[i] = get_number(numbers);
}

// Room for the number of a pixel that was computed with rows of another length: it is not one of
// these doubles, but the answer is judged by the others, and not by its damage to the heap.
static size_t room_for_slips(const Image *image)
{
    size_t sides = (size_t)image->size.width + (size_t)image->size.height;
    return sides <= 2048 ? sides * sides : pixels_of(image) + 1;
}

double *numbers_get_doubles(Numbers *numbers, const Image *image)
{
    size_t room = room_for_slips(image);
    double *doubles = malloc((1 + room) * sizeof *doubles);
    if (doubles == NULL) {
        numbers->bad = true;
        return NULL;
    }
    *doubles++ = GUARD_DEPTH;
    for (size_t i = pixels_of(image); i < room; i++)
        doubles[i] = GUARD_DEPTH;
    numbers_get_into_doubles(numbers, doubles, image);
    return doubles;
}

void numbers_free_doubles(double *doubles)
{
    if (doubles != NULL)
        free(doubles - 1);
}

bool doubles_overran(const double *doubles, const Image *image)
{
    if (doubles[-1] != GUARD_DEPTH)
        return true;
    for (size_t i = pixels_of(image); i < room_for_slips(image); i++)
        if (doubles[i] != GUARD_DEPTH)
            return true;
    return false;
}

// ---- the results of an exercise ----------------------------------------------------------------

// How many of these results are bytes of pixels; depths may follow them.
static int numbers_of_pixels(const char *types, const Numbers *numbers)
{
    return strcmp(types, "Pixels") == 0           ? numbers->count
           : strcmp(types, "Pixels Doubles") == 0 ? numbers->count / 4 * 3
                                                  : 0;
}

void numbers_check(Numbers *numbers, const char *types, int count)
{
    char name[32];
    int used = 0;
    numbers->bad = numbers->bad || numbers->count != count;
    for (int i = numbers_of_pixels(types, numbers); i > 0; i--)
        get_whole(numbers, 0, UINT8_MAX);
    for (; sscanf(types, " %31s%n", name, &used) == 1; types += used) {
        _Alignas(32) unsigned char value[TYPE_MOST_BYTES];
        if (type_named(name) != NULL)
            numbers_get(numbers, type_named(name), value);
        else
            numbers->read = numbers->bad ? numbers->read : count;
    }
}

typedef struct {
    int count;
    const char **names;
} Names;

static void add_name(void *context, const char *name, void *at, size_t size, bool is_double)
{
    Names *all = context;
    (void)at, (void)size, (void)is_double;
    if (all->count < MOST_PLACES)
        all->names[all->count++] = name;
}

int layout_names(const char *types, const char *names[MOST_PLACES])
{
    char name[32];
    int used = 0;
    Names all = {0, names};
    for (; sscanf(types, " %31s%n", name, &used) == 1; types += used) {
        _Alignas(32) unsigned char value[TYPE_MOST_BYTES] = {0};
        const Type *type = type_named(name);
        if (type != NULL && type_is_flat(type))
            type_visit(type, "", value, add_name, &all);
    }
    return all.count;
}

bool layout_is_step(const Exercise *exercise)
{
    return strcmp(exercise->arguments, "Sphere vec3 vec3") == 0 &&
           strcmp(exercise->results, "vec3") == 0;
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

bool numbers_same(const Numbers *a, const Numbers *b)
{
    bool same = a->count == b->count;
    for (int i = 0; same && i < a->count; i++)
        same = same_double(a->at[i], b->at[i]);
    return same;
}
