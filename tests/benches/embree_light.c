// embree_light.c - Embree 3 as a peer for shaded pictures: it traces, chapter 07's functions shade.
//
// Its fastest way here: 16 rays in each call, and a test of ours for 16 lanes (embree.c), for the
// rays from the eye, to the lights and from mirrors. As in chapter 08, rays are gathered from many
// samples, a light that is behind its surface is not asked, and a pixel without spheres gets the
// background at once.
#include "chapters/08-fast/engines/engine.h"
#include "common/clock.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/07-shading.h"
#include "tests/benches/embree.h"

#include <stdlib.h>
#include <string.h>

enum { LANES = 16, SIDE = 16, PATHS = SIDE * SIDE };

typedef struct {
    const Work *work;
    Rendering rendering;
    RTCScene spheres;
    uint8_t background[3];
} Peer;

typedef struct {
    Ray ray;
    Hit hit;
    vec3 normal, start;
    int last; // the mirrors it followed
} Path;

// A block of samples; the pixels of it are computed when all its samples have their colors.
typedef struct {
    const Peer *peer;
    Scene alone; // one sphere, and the lights that arrive
    Pixel corner;
    Resolution size;
    int count;
    Path *paths;
    bool *lit;
    Color *colors; // of each mirror and path; in the end the first are the samples'
    double *parts;
} Block;

// ---- packets ---------------------------------------------------------------------------------

static void set_ray(struct RTCRay16 *packet, int i, Ray ray, float reach)
{
    packet->org_x[i] = (float)ray.origin[0];
    packet->org_y[i] = (float)ray.origin[1];
    packet->org_z[i] = (float)ray.origin[2];
    packet->dir_x[i] = (float)ray.direction[0];
    packet->dir_y[i] = (float)ray.direction[1];
    packet->dir_z[i] = (float)ray.direction[2];
    packet->tnear[i] = packet->time[i] = 0;
    packet->tfar[i] = reach;
    packet->mask[i] = ~0U;
    packet->id[i] = packet->flags[i] = 0;
}

static void begin(struct RTCIntersectContext *context, bool coherent)
{
    rtcInitIntersectContext(context);
    context->flags =
        coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
}

static void find_hits(Block *block, const int *going, int count, bool coherent)
{
    const Scene *scene = block->peer->work->scene;
    struct RTCIntersectContext context;
    begin(&context, coherent);
    for (int first = 0; first < count; first += LANES) {
        struct RTCRayHit16 packet;
        int valid[LANES], some = count - first < LANES ? count - first : LANES;
        for (int i = 0; i < LANES; i++) {
            valid[i] = i < some ? -1 : 0;
            packet.hit.geomID[i] = packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
            set_ray(&packet.ray, i, block->paths[going[first + (i < some ? i : 0)]].ray, INFINITY);
        }
        rtcIntersect16(valid, block->peer->spheres, &context, &packet);
        for (int i = 0; i < some; i++) {
            Path *path = &block->paths[going[first + i]];
            path->hit = (Hit){NO_HIT, -1};
            if (packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID)
                continue;
            int sphere = (int)packet.hit.primID[i];
            double t = hit_sphere(path->ray, scene->spheres[sphere]);
            path->hit = (Hit){t == NO_HIT ? (double)packet.ray.tfar[i] : t, sphere};
        }
    }
}

static void find_light(Block *block, const int *going, int count, int number)
{
    const Scene *scene = block->peer->work->scene;
    Light light = scene->lights[number];
    struct RTCIntersectContext context;
    begin(&context, false);
    struct RTCRay16 packet = {0};
    int asking[LANES], valid[LANES], some = 0;
    for (int k = 0; k < count; k++) {
        Path *path = &block->paths[going[k]];
        Ray ray = ray_to_light(path->start, light);
        bool behind = vec3_dot(ray.direction, path->normal) < 0;
        block->lit[going[k] * scene->light_count + number] = false;
        if (!behind) {
            asking[some] = going[k];
            set_ray(&packet, some++, ray, light.kind == LIGHT_DISTANT ? INFINITY : 1);
        }
        if (some < LANES && (k < count - 1 || some == 0))
            continue;
        for (int i = 0; i < LANES; i++)
            valid[i] = i < some ? -1 : 0;
        // If Embree divides the 16 rays, it does not look at valid: a ray that is not asked ends
        // before it begins.
        for (int i = some; i < LANES; i++)
            packet.tfar[i] = -1;
        rtcOccluded16(valid, block->peer->spheres, &context, &packet);
        for (int i = 0; i < some; i++)
            block->lit[asking[i] * scene->light_count + number] = packet.tfar[i] >= 0;
        some = 0;
    }
}

// ---- paths -----------------------------------------------------------------------------------

static Color color_of_surface(Block *block, int number)
{
    const Scene *scene = block->peer->work->scene;
    const Path *path = &block->paths[number];
    Sphere sphere = scene->spheres[path->hit.sphere];
    block->alone.spheres = &sphere;
    block->alone.light_count = 0;
    for (int i = 0; i < scene->light_count; i++)
        if (block->lit[number * scene->light_count + i])
            block->alone.lights[block->alone.light_count++] = scene->lights[i];
    return shade(&block->alone, path->ray, (Hit){path->hit.t, 0});
}

static void leave_surface(Path *path, Sphere sphere)
{
    vec3 point = path->ray.origin + path->hit.t * path->ray.direction;
    vec3 normal = surface_normal(sphere, point);
    path->normal = vec3_dot(normal, path->ray.direction) > 0 ? -normal : normal;
    // Farther off the surface than offset_from_surface: Embree's floats need it.
    path->start = point + 1e-4 * sphere.radius * path->normal;
}

// One step of all paths that go on. Returns the number of those that continue from mirrors.
static int step(Block *block, int *going, int count, int level)
{
    const Scene *scene = block->peer->work->scene;
    int on_surface = 0, mirrored = 0;
    for (int k = 0; k < count; k++) {
        Path *path = &block->paths[going[k]];
        path->last = level;
        block->colors[level * PATHS + going[k]] = scene->background;
        if (path->hit.sphere < 0)
            continue;
        leave_surface(path, scene->spheres[path->hit.sphere]);
        going[on_surface++] = going[k];
    }
    for (int i = 0; i < scene->light_count; i++)
        find_light(block, going, on_surface, i);
    for (int k = 0; k < on_surface; k++) {
        Path *path = &block->paths[going[k]];
        double specular = scene_surface(scene, path->hit.sphere)->specular;
        block->colors[level * PATHS + going[k]] = color_of_surface(block, going[k]);
        block->parts[level * PATHS + going[k]] = specular;
        if (level == block->peer->rendering.style.depth || !(specular > 0))
            continue;
        path->ray = (Ray){path->start, mirror_direction(path->ray.direction, path->normal)};
        going[mirrored++] = going[k];
    }
    return mirrored;
}

static void trace(Block *block)
{
    int going[PATHS], count = block->count;
    for (int i = 0; i < count; i++)
        going[i] = i;
    for (int level = 0, left = count; left > 0; level++) {
        find_hits(block, going, left, level == 0);
        left = step(block, going, left, level);
    }
    for (int i = 0; i < count; i++) {
        int level = block->paths[i].last;
        Color color = block->colors[level * PATHS + i];
        while (level-- > 0)
            color = block->colors[level * PATHS + i] + block->parts[level * PATHS + i] * color;
        block->colors[i] = color;
    }
}

// ---- blocks ----------------------------------------------------------------------------------

// Samples in squares of 4 x 4, so that 16 rays in a row are neighbours.
static int place_of(const Block *block, int column, int row)
{
    int squares = (block->size.width + 3) / 4;
    return 16 * (row / 4 * squares + column / 4) + row % 4 * 4 + column % 4;
}

static Color sample_color(void *world, Pixel sample, Ray ray, int depth)
{
    const Block *block = world;
    (void)ray, (void)depth;
    return block->colors[place_of(block, sample.column - block->corner.column,
                                  sample.row - block->corner.row)];
}

static Color see_background(void *world, Pixel sample, Ray ray, int depth)
{
    const Peer *peer = world;
    (void)sample, (void)ray, (void)depth;
    return peer->work->scene->background;
}

static void set_pixel(uint8_t *rgb, Color color)
{
    for (int i = 0; i < 3; i++)
        rgb[i] = byte_from_color(color[i]);
}

static bool sees_nothing(const Block *block, int column, int row, int samples)
{
    for (int y = row; y < row + samples; y++)
        for (int x = column; x < column + samples; x++)
            if (block->paths[place_of(block, x, y)].last > 0 ||
                block->paths[place_of(block, x, y)].hit.sphere >= 0)
                return false;
    return true;
}

static void paint(Block *block, int samples)
{
    const Peer *peer = block->peer;
    Image *image = peer->work->image;
    for (int row = 0; row < block->size.height; row += samples)
        for (int column = 0; column < block->size.width; column += samples) {
            Pixel pixel = {(block->corner.column + column) / samples,
                           (block->corner.row + row) / samples};
            if (sees_nothing(block, column, row, samples))
                memcpy(image_bytes(image, pixel), peer->background, 3);
            else
                set_pixel(image_bytes(image, pixel), render_pixel(&peer->rendering, block, pixel));
        }
}

static void blocks_in_a_row(void *given, int number)
{
    const Peer *peer = given;
    const Scene *scene = peer->work->scene;
    size_t lights = (size_t)scene->light_count + 1;
    size_t levels = (size_t)peer->rendering.style.depth + 1;
    int samples = peer->rendering.style.samples;
    Resolution screen = {peer->work->image->size.width * samples,
                         peer->work->image->size.height * samples};
    Block block = {.peer = peer, .alone = *scene};
    block.alone.sphere_count = 1;
    block.alone.lights = malloc(lights * sizeof(Light));
    block.paths = malloc(PATHS * sizeof(Path));
    block.lit = malloc(lights * PATHS);
    block.colors = malloc(levels * PATHS * sizeof(Color));
    block.parts = malloc(levels * PATHS * sizeof(double));
    if (block.alone.lights == NULL || block.paths == NULL || block.lit == NULL ||
        block.colors == NULL || block.parts == NULL)
        exit(1);
    int side = SIDE / samples * samples, top = number * side;
    for (int left = 0; left < screen.width; left += side) {
        block.corner = (Pixel){left, top};
        block.size = (Resolution){screen.width - left < side ? screen.width - left : side,
                                  screen.height - top < side ? screen.height - top : side};
        int width = (block.size.width + 3) / 4 * 4, height = (block.size.height + 3) / 4 * 4;
        block.count = width * height;
        // At the edges of the picture, some rays more.
        for (int row = 0; row < height; row++)
            for (int column = 0; column < width; column++)
                block.paths[place_of(&block, column, row)].ray =
                    pixel_ray(peer->rendering.camera, screen, (Pixel){left + column, top + row});
        trace(&block);
        paint(&block, samples);
    }
    free(block.alone.lights);
    free(block.paths);
    free(block.lit);
    free(block.colors);
    free(block.parts);
}

bool light_embree(const Work *work, Style style, Message *message)
{
    EmbreeSpheres spheres;
    if (style.samples > SIDE || !embree_spheres(&spheres, work->scene, work->threads))
        return message_set(message, "Embree cannot be set up");
    Peer peer = {.work = work,
                 .rendering = {work->camera, work->image->size, style, sample_color},
                 .spheres = spheres.scene};
    Rendering empty = peer.rendering;
    empty.trace = see_background;
    set_pixel(peer.background, render_pixel(&empty, &peer, (Pixel){0, 0}));
    if (work->built != NULL)
        *work->built = clock_seconds();
    int side = SIDE / style.samples, height = work->image->size.height;
    in_parallel(work->threads, (height + side - 1) / side, blocks_in_a_row, &peer);
    embree_free(&spheres);
    return true;
}
