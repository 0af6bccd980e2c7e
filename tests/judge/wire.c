// wire.c - one message between the judge and the answering process.
#include "tests/judge/wire.h"

#include <string.h>

void wire_clear(Wire *wire)
{
    wire->size = wire->read = 0;
    wire->bad = false;
    wire->overran = false;
}

bool wire_make_room(Wire *wire, uint64_t size)
{
    if (size > WIRE_MOST_BYTES)
        return false;
    if (size <= wire->room)
        return true;
    size_t room = 2 * (size_t)size + 256;
    uint8_t *bytes = realloc(wire->bytes, room);
    if (bytes == NULL)
        return false;
    wire->bytes = bytes;
    wire->room = room;
    return true;
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

bool wire_allows_depth(const Wire *wire, int depth)
{
    return !wire->is_hostile || depth <= WIRE_MOST_DEPTH;
}

bool wire_allows_hit(const Wire *wire, Hit hit, const Scene *scene)
{
    return !wire->is_hostile || (hit.sphere >= 0 && hit.sphere < scene->sphere_count);
}

bool wire_allows_light(const Wire *wire, Light light)
{
    return !wire->is_hostile || light.kind == LIGHT_POINT || light.kind == LIGHT_DISTANT;
}

bool wire_allows_world(const Wire *wire, Handedness world)
{
    return !wire->is_hostile || world == LEFT_HANDED || world == RIGHT_HANDED;
}

static void put_zeros_behind(Wire *wire, const void *value, size_t used, size_t size)
{
    static const uint8_t zeros[32];
    wire_put(wire, value, used);
    wire_put(wire, zeros, size - used);
}

void wire_put_camera(Wire *wire, const Camera *camera)
{
    put_zeros_behind(wire, camera, offsetof(Camera, height) + sizeof camera->height,
                     sizeof *camera);
}

void wire_put_sphere(Wire *wire, const Sphere *sphere)
{
    put_zeros_behind(wire, sphere, offsetof(Sphere, surface) + sizeof sphere->surface,
                     sizeof *sphere);
}

void wire_put_hit(Wire *wire, const Hit *hit)
{
    put_zeros_behind(wire, hit, offsetof(Hit, sphere) + sizeof hit->sphere, sizeof *hit);
}

void wire_put_light(Wire *wire, const Light *light)
{
    put_zeros_behind(wire, light, offsetof(Light, kind) + sizeof light->kind, sizeof *light);
}

static void put_surface(Wire *wire, const Surface *surface)
{
    put_zeros_behind(wire, surface, offsetof(Surface, refraction) + sizeof surface->refraction,
                     sizeof *surface);
}

static void *get_items(Wire *wire, int *count, size_t size, const void *guard)
{
    wire_get(wire, count, sizeof *count);
    if (wire->bad || *count < 0 || (size_t)*count > (wire->size - wire->read) / size) {
        wire->bad = true;
        *count = 0;
        return NULL;
    }
    char *items = malloc(((size_t)*count + 1) * size);
    if (items == NULL) {
        wire->bad = true;
        *count = 0;
        return NULL;
    }
    wire_get(wire, items, (size_t)*count * size);
    memcpy(items + (size_t)*count * size, guard, size);
    return items;
}

void wire_put_scene(Wire *wire, const Scene *scene)
{
    wire_put(wire, &scene->view, sizeof scene->view);
    wire_put(wire, &scene->background, sizeof scene->background);
    wire_put(wire, &scene->ambient, sizeof scene->ambient);
    wire_put(wire, &scene->sphere_count, sizeof scene->sphere_count);
    for (int i = 0; i < scene->sphere_count; i++)
        wire_put_sphere(wire, &scene->spheres[i]);
    wire_put(wire, &scene->surface_count, sizeof scene->surface_count);
    for (int i = 0; i < scene->surface_count; i++)
        put_surface(wire, &scene->surfaces[i]);
    wire_put(wire, &scene->light_count, sizeof scene->light_count);
    for (int i = 0; i < scene->light_count; i++)
        wire_put_light(wire, &scene->lights[i]);
}

void wire_get_scene(Wire *wire, Scene *scene)
{
    static const Surface guard_surface = {{0.93, 0.07, 0.91}, 0.5, 0.5, 10, 0, 1};
    *scene = (Scene){0};
    wire_get(wire, &scene->view, sizeof scene->view);
    wire_get(wire, &scene->background, sizeof scene->background);
    wire_get(wire, &scene->ambient, sizeof scene->ambient);
    scene->spheres = get_items(wire, &scene->sphere_count, sizeof *scene->spheres, &GUARD_SPHERE);
    scene->surfaces =
        get_items(wire, &scene->surface_count, sizeof *scene->surfaces, &guard_surface);
    scene->lights = get_items(wire, &scene->light_count, sizeof *scene->lights, &GUARD_LIGHT);
    for (int i = 0; i < scene->sphere_count; i++)
        if (scene->spheres[i].surface < 0 || scene->spheres[i].surface >= scene->surface_count)
            wire->bad = true;
    for (int i = 0; i < scene->light_count; i++)
        if (!wire_allows_light(wire, scene->lights[i]))
            wire->bad = true;
}

static size_t pixels_of(const Image *image)
{
    return (size_t)image->size.width * (size_t)image->size.height;
}

void wire_put_pixels(Wire *wire, const Image *image)
{
    wire_put(wire, image->rgb, 3 * pixels_of(image));
}

void wire_get_pixels(Wire *wire, Image *image)
{
    wire_get(wire, image->rgb, 3 * pixels_of(image));
}

void wire_put_image(Wire *wire, const Image *image)
{
    wire_put(wire, &image->size, sizeof image->size);
    wire_put_pixels(wire, image);
}

enum { PIXEL_GUARD = 3 * 64, GUARD_BYTE = 0xa6 };

void wire_get_image(Wire *wire, Image *image)
{
    Message message;
    Resolution size;
    wire_get(wire, &size, sizeof size);
    // A picture that is not in the message would be made of memory that is not there.
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

// Room for a pixel's number that was computed with rows of another length: it is not one of these
// doubles, but the answer is judged by the others, and not by what it did to the heap.
static size_t room_for_slips(const Image *image)
{
    size_t sides = (size_t)image->size.width + (size_t)image->size.height;
    return sides <= 2048 ? sides * sides : pixels_of(image) + 1;
}

double *wire_get_doubles(Wire *wire, const Image *image)
{
    size_t room = room_for_slips(image);
    double *doubles = malloc(room * sizeof *doubles);
    if (doubles == NULL) {
        wire->bad = true;
        return NULL;
    }
    for (size_t i = pixels_of(image); i < room; i++)
        doubles[i] = GUARD_DEPTH;
    wire_get_into_doubles(wire, doubles, image);
    return doubles;
}

bool wire_doubles_overran(const double *doubles, const Image *image)
{
    for (size_t i = pixels_of(image); i < room_for_slips(image); i++)
        if (doubles[i] != GUARD_DEPTH)
            return true;
    return false;
}
