// wire.c - one message between the judge and the answering process.
#include "tests/judge/wire.h"

#include <string.h>

void wire_clear(Wire *wire)
{
    wire->size = wire->read = 0;
    wire->bad = false;
    wire->overran = false;
}

static uint8_t *block_of(const Wire *wire)
{
    return wire->bytes != NULL ? wire->bytes - sizeof(WireHeader) : NULL;
}

bool wire_make_room(Wire *wire, uint64_t size)
{
    if (size > WIRE_MOST_BYTES)
        return false;
    if (size <= wire->room && wire->bytes != NULL)
        return true;
    size_t room = 2 * (size_t)size + 256;
    uint8_t *block = realloc(block_of(wire), sizeof(WireHeader) + room);
    if (block == NULL)
        return false;
    wire->bytes = block + sizeof(WireHeader);
    wire->room = room;
    return true;
}

void wire_free(Wire *wire)
{
    free(block_of(wire));
    *wire = (Wire){.bytes = NULL};
}

const void *wire_block(Wire *wire, const WireHeader *header, size_t *size)
{
    if (!wire_make_room(wire, wire->size))
        return NULL;
    *size = sizeof *header + wire->size;
    return memcpy(block_of(wire), header, sizeof *header);
}

void wire_put(Wire *wire, const void *value, size_t size)
{
    if (size > WIRE_MOST_BYTES || !wire_make_room(wire, wire->size + size)) {
        wire->bad = true;
        return;
    }
    if (size > 0)
        memcpy(wire->bytes + wire->size, value, size);
    wire->size += size;
}

void wire_get(Wire *wire, void *value, size_t size)
{
    if (wire->bad || size > wire->size - wire->read) {
        wire->bad = true;
        memset(value, 0xff, size); // the impossible, as of a blank
        return;
    }
    if (size > 0)
        memcpy(value, wire->bytes + wire->read, size);
    wire->read += size;
}

bool wire_is_read(const Wire *wire)
{
    return !wire->bad && wire->read == wire->size;
}

static size_t pixels_of(const Image *image)
{
    return (size_t)image->size.width * (size_t)image->size.height;
}

// Every value of a field that has several: a list's count crosses before its items.
static const char *items_of(const Field *field, const void *value, int *count)
{
    const char *items;
    memcpy(&items, (const char *)value + field->offset, sizeof items);
    memcpy(count, (const char *)value + field->count_at, sizeof *count);
    return items;
}

static void put_flat(Wire *wire, const Type *type, const void *value)
{
    if (type->size == 0)
        return;
    if (!wire_make_room(wire, wire->size + type->size)) {
        wire->bad = true;
        return;
    }
    memset(wire->bytes + wire->size, 0, type->size);
    type_copy(type, wire->bytes + wire->size, value);
    wire->size += type->size;
}

void wire_put_value(Wire *wire, const Type *type, const void *value)
{
    if (type_is_flat(type)) {
        put_flat(wire, type, value);
        return;
    }
    for (const Field *field = type->fields; field < type->fields + type->count; field++) {
        if (field->kind == FIELD_OF_ONE)
            wire_put_value(wire, field->type, (const char *)value + field->offset);
        if (field->kind == FIELD_OF_PIXELS)
            wire_put_pixels(wire, value);
        if (field->kind == FIELD_OF_LIST) {
            int count;
            const char *items = items_of(field, value, &count);
            wire_put(wire, &count, sizeof count);
            for (int i = 0; i < count; i++)
                wire_put_value(wire, field->type, items + (size_t)i * field->type->size);
        }
    }
}

static int padding = 0xff;

void wire_fill_padding_with(int byte)
{
    padding = byte;
}

static void get_flat(Wire *wire, const Type *type, void *value)
{
    unsigned char bytes[TYPE_MOST_BYTES];
    if (type->size == 0)
        return;
    wire_get(wire, bytes, type->size);
    memset(value, padding, type->size);
    type_copy(type, value, bytes);
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

static void get_list(Wire *wire, const Field *field, void *value)
{
    int count;
    size_t size = field->type->size;
    wire_get(wire, &count, sizeof count);
    bool is_there = !wire->bad && count >= 0 && (size_t)count <= (wire->size - wire->read) / size;
    char *items = is_there ? malloc(((size_t)count + 2) * size) : NULL;
    if (items == NULL) {
        wire->bad = true;
        count = 0;
    } else {
        memcpy(items, guard_of(field->type), size);
        items += size;
    }
    memcpy((char *)value + field->offset, &items, sizeof items);
    memcpy((char *)value + field->count_at, &count, sizeof count);
    for (int i = 0; i < count; i++)
        wire_get_value(wire, field->type, items + (size_t)i * size);
    if (items != NULL)
        memcpy(items + (size_t)count * size, guard_of(field->type), size);
}

#define GUARD_DEPTH 1.2345678901234567e300
enum { PIXEL_GUARD = 3 * 64, GUARD_BYTE = 0xa6 };

static void get_image(Wire *wire, Image *image)
{
    Message message;
    Resolution size = image->size;
    // A picture that is not in the message would be read from memory that is not there.
    bool is_there = !wire->bad && size.width > 0 && size.height > 0 &&
                    (uint64_t)size.width * (uint64_t)size.height <= (wire->size - wire->read) / 3;
    if (!is_there || !image_create(image, size, &message)) {
        *image = (Image){0};
        wire->bad = true;
        return;
    }
    uint8_t *rgb = realloc(image->rgb, 3 * pixels_of(image) + PIXEL_GUARD);
    if (rgb == NULL) {
        image_free(image);
        wire->bad = true;
        return;
    }
    image->rgb = rgb;
    memset(rgb + 3 * pixels_of(image), GUARD_BYTE, PIXEL_GUARD);
    wire_get_pixels(wire, image);
}

bool is_light_kind(LightKind kind)
{
    return kind == LIGHT_POINT || kind == LIGHT_DISTANT;
}

static bool is_sane(const Wire *wire, const Scene *scene)
{
    bool sane = true;
    for (int i = 0; i < scene->sphere_count; i++)
        sane = sane && scene->spheres[i].surface >= 0 &&
               scene->spheres[i].surface < scene->surface_count;
    for (int i = 0; i < scene->light_count; i++)
        sane = sane && (!wire->is_hostile || is_light_kind(scene->lights[i].kind));
    return sane;
}

void wire_get_value(Wire *wire, const Type *type, void *value)
{
    if (type_is_flat(type)) {
        get_flat(wire, type, value);
        return;
    }
    memset(value, padding, type->size);
    for (const Field *field = type->fields; field < type->fields + type->count; field++) {
        if (field->kind == FIELD_OF_ONE)
            wire_get_value(wire, field->type, (char *)value + field->offset);
        if (field->kind == FIELD_OF_PIXELS)
            get_image(wire, value);
        if (field->kind == FIELD_OF_LIST)
            get_list(wire, field, value);
    }
    if (type == &type_Scene && !is_sane(wire, value))
        wire->bad = true;
}

void wire_free_value(const Type *type, void *value)
{
    for (int i = 0; type->kind == TYPE_OF_FIELDS && i < type->count; i++) {
        char *items;
        if (type->fields[i].kind == FIELD_OF_ONE)
            continue;
        memcpy(&items, (char *)value + type->fields[i].offset, sizeof items);
        if (items != NULL && type->fields[i].kind == FIELD_OF_LIST)
            items -= type->fields[i].type->size; // the guard before the first
        free(items);
    }
}

void wire_put_pixels(Wire *wire, const Image *image)
{
    wire_put(wire, image->rgb, 3 * pixels_of(image));
}

void wire_get_pixels(Wire *wire, Image *image)
{
    wire_get(wire, image->rgb, 3 * pixels_of(image));
}

bool wire_pixels_overran(const Image *image)
{
    const uint8_t *guard = image->rgb + 3 * pixels_of(image);
    for (size_t i = 0; i < PIXEL_GUARD; i++)
        if (guard[i] != GUARD_BYTE)
            return true;
    return false;
}

void wire_put_doubles(Wire *wire, const double *doubles, const Image *image)
{
    wire_put(wire, doubles, sizeof *doubles * pixels_of(image));
}

void wire_get_into_doubles(Wire *wire, double *doubles, const Image *image)
{
    wire_get(wire, doubles, sizeof *doubles * pixels_of(image));
}

// Room for the number of a pixel that was computed with rows of another length: it is not one of
// these doubles, but the answer is judged by the others, and not by its damage to the heap.
static size_t room_for_slips(const Image *image)
{
    size_t sides = (size_t)image->size.width + (size_t)image->size.height;
    return sides <= 2048 ? sides * sides : pixels_of(image) + 1;
}

double *wire_get_doubles(Wire *wire, const Image *image)
{
    size_t room = room_for_slips(image);
    double *doubles = malloc((1 + room) * sizeof *doubles);
    if (doubles == NULL) {
        wire->bad = true;
        return NULL;
    }
    *doubles++ = GUARD_DEPTH;
    for (size_t i = pixels_of(image); i < room; i++)
        doubles[i] = GUARD_DEPTH;
    wire_get_into_doubles(wire, doubles, image);
    return doubles;
}

void wire_free_doubles(double *doubles)
{
    if (doubles != NULL)
        free(doubles - 1);
}

bool wire_doubles_overran(const double *doubles, const Image *image)
{
    if (doubles[-1] != GUARD_DEPTH)
        return true;
    for (size_t i = pixels_of(image); i < room_for_slips(image); i++)
        if (doubles[i] != GUARD_DEPTH)
            return true;
    return false;
}
