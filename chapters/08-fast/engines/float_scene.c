// float_scene.c - steps 4 and 5: the scene becomes floats, seen from the eye, in the order of the
// hierarchy. Tiles of pixels are cast in floats; step 3 decides the pixels in doubt.
#include "chapters/08-fast/engines/float_bounds.h"

#include "chapters/08-fast/engines/covered_pixels.h"
#include "chapters/08-fast/engines/engine.h"
#include "chapters/08-fast/engines/number_limits.h"
#include "chapters/08-fast/engines/parallel.h"
#include "chapters/08-fast/engines/sphere_colors.h"
#include "common/clock.h"
#include "common/large_pages.h"
#include "exercises/04-pixel-ray.h"

#include <stdatomic.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    const Work *work;
    // For every camera: the hierarchy, and the arrays in its order.
    Hierarchy hierarchy;
    Paint *paints;
    Unseen *unseen;
    WideNode *wide; // if it is needed
    int *colors;
    // For this camera.
    See *see;
    Seen *seen;
    SeenNode *nodes; // if wide is not needed
    int *around;
    float *x, *y;
    atomic_int found; // SEEN_AROUND | SEEN_BADLY
    View view;
} SeenScene;

enum { AT_A_TIME = 64 * SEEN_AT_ONCE }; // spheres or nodes, by one thread

static int parts(int of)
{
    return of / AT_A_TIME + (of % AT_A_TIME > 0);
}

// ---- for every camera -------------------------------------------------------------------------

static int color_of(Paint paint)
{
    uint8_t bytes[sizeof(int)] = {paint.rgb[0], paint.rgb[1], paint.rgb[2]};
    int color;
    memcpy(&color, bytes, sizeof color);
    return color;
}

// The spheres in the order of the hierarchy, as arrays that lanes can read.
static void line_up(void *given, int part)
{
    SeenScene *scene = given;
    const Scene *from = scene->work->scene;
    int begin = part * AT_A_TIME, end = begin + AT_A_TIME;
    int padded = (from->sphere_count + SEEN_AT_ONCE - 1) / SEEN_AT_ONCE * SEEN_AT_ONCE;
    for (int i = begin; i < end && i < padded; i++) {
        // The spheres that fill up the last 64 are never used.
        int place = i < from->sphere_count ? i : 0;
        const Sphere *sphere = &from->spheres[scene->hierarchy.order[place]];
        const double *numbers = scene->hierarchy.numbers + 4 * (size_t)place;
        Unseen *unseen = &scene->unseen[i / SEEN_AT_ONCE];
        unseen->x[i % SEEN_AT_ONCE] = numbers[0];
        unseen->y[i % SEEN_AT_ONCE] = numbers[1];
        unseen->z[i % SEEN_AT_ONCE] = numbers[2];
        unseen->radius[i % SEEN_AT_ONCE] = numbers[3];
        scene->colors[i] = color_of(scene->paints[sphere->surface]);
    }
}

// Prepares the part for every camera. False if there is not enough memory. Free it in both cases.
static bool seen_scene_build(SeenScene *scene, const Work *work, bool wide)
{
    const size_t count = (size_t)work->scene->sphere_count, padded = count + SEEN_AT_ONCE;
    static See *const sees[LANES_KINDS] = LANES_TABLE(see);
    *scene = (SeenScene){.work = work, .paints = paints_of(work->scene), .see = sees[lanes_best()]};
    scene->unseen = large_memory((count / SEEN_AT_ONCE + 1) * sizeof *scene->unseen);
    scene->colors = large_memory(padded * sizeof *scene->colors);
    scene->seen = large_memory(padded * sizeof *scene->seen);
    scene->around = malloc((count + 1) * sizeof *scene->around);
    scene->x = malloc(((size_t)work->image->size.width + TILE) * sizeof *scene->x);
    scene->y = malloc(((size_t)work->image->size.height + TILE) * sizeof *scene->y);
    if (scene->paints == NULL || scene->unseen == NULL || scene->colors == NULL ||
        scene->seen == NULL || scene->around == NULL || scene->x == NULL || scene->y == NULL ||
        !hierarchy_build(&scene->hierarchy, work->scene, SMALL_LEAF, work->threads))
        return false;
    WideCount number;
    if (count > 0 && wide)
        scene->wide = wide_build(&scene->hierarchy, 1, SMALL_LEAF, work->threads, &number);
    else if (count > 0)
        scene->nodes = large_memory((size_t)scene->hierarchy.node_count * sizeof *scene->nodes);
    in_parallel(work->threads, parts(work->scene->sphere_count), line_up, scene);
    return count == 0 || scene->wide != NULL || scene->nodes != NULL;
}

static void seen_scene_free(SeenScene *scene)
{
    free(scene->nodes);
    free(scene->wide);
    free(scene->y);
    free(scene->x);
    free(scene->around);
    free(scene->seen);
    free(scene->colors);
    free(scene->unseen);
    free(scene->paints);
    hierarchy_free(&scene->hierarchy);
}

// ---- for one camera ---------------------------------------------------------------------------

static void see_spheres(void *given, int part)
{
    SeenScene *scene = given;
    int begin = part * AT_A_TIME, end = begin + AT_A_TIME, found = 0;
    for (int i = begin; i < end && i < scene->work->scene->sphere_count; i += SEEN_AT_ONCE)
        found |= scene->see(&scene->view, &scene->unseen[i / SEEN_AT_ONCE], &scene->seen[i]);
    atomic_fetch_or(&scene->found, found);
}

// Boxes as floats, from the eye, a little larger (SeenNode).
static void see_nodes(void *given, int part)
{
    SeenScene *scene = given;
    const Hierarchy *hierarchy = &scene->hierarchy;
    int begin = part * AT_A_TIME, end = begin + AT_A_TIME;
    for (int i = begin; i < end && i < hierarchy->node_count; i++) {
        const Node *node = &hierarchy->nodes[i];
        double low[3], high[3], reach = 0;
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = node->box.low[axis] - scene->view.eye[axis];
            high[axis] = node->box.high[axis] - scene->view.eye[axis];
            reach = -low[axis] > reach ? -low[axis] : reach;
            reach = high[axis] > reach ? high[axis] : reach;
        }
        SeenNode *seen = &scene->nodes[i];
        for (int axis = 0; axis < 3; axis++) {
            seen->low[axis] = (float)(low[axis] - 0x1p-19 * reach);
            seen->high[axis] = (float)(high[axis] + 0x1p-19 * reach);
        }
        bool leaf = node->other == 0;
        seen->other = leaf ? node->first : node->other;
        seen->count = (short)(leaf ? node->count : 0);
        seen->axis = (short)node->axis;
    }
}

// The spheres around the eye: every ray hits them, so they have no outline.
static void find_around(SeenScene *scene)
{
    for (int i = 0; i < scene->work->scene->sphere_count; i++) {
        const Seen *seen = &scene->seen[i];
        float squared = seen->x * seen->x + seen->y * seen->y + seen->z * seen->z;
        if (squared < seen->smaller)
            scene->around[scene->view.around_count++] = i;
    }
}

static void set_view(SeenScene *scene)
{
    Camera camera = scene->work->camera;
    Resolution screen = scene->work->image->size;
    double width = camera.width / camera.distance, height = camera.height / camera.distance;
    View *view = &scene->view;
    *view = (View){.nodes = scene->nodes,
                   .wide = scene->wide,
                   .seen = scene->seen,
                   .colors = scene->colors,
                   .background = color_of(scene->paints[scene->work->scene->surface_count]),
                   .around = scene->around,
                   .scale_x = screen.width / width,
                   .scale_y = screen.height / height,
                   .middle_x = screen.width / 2.0,
                   .middle_y = screen.height / 2.0,
                   .columns = (screen.width + BLOCK - 1) / BLOCK,
                   .rows = (screen.height + BLOCK - 1) / BLOCK,
                   .x = scene->x,
                   .y = scene->y};
    view_store(view->eye, camera.origin);
    view_store(view->right, camera.right);
    view_store(view->up, camera.up);
    view_store(view->ahead, camera.forward);
    for (int i = 0; i < screen.width + TILE; i++)
        scene->x[i] = (float)(((i + 0.5) / screen.width - 0.5) * width);
    for (int i = 0; i < screen.height + TILE; i++)
        scene->y[i] = (float)((0.5 - (i + 0.5) / screen.height) * height);
}

// Prepares the part for this camera. False if floats are not good enough: see SEEN_BADLY. That is
// also the case for rays nearly at right angles to the view.
static bool seen_scene_look(SeenScene *scene)
{
    const Work *work = scene->work;
    Camera camera = work->camera;
    if (camera.width > 500 * camera.distance || camera.height > 500 * camera.distance)
        return false;
    set_view(scene);
    in_parallel(work->threads, parts(work->scene->sphere_count), see_spheres, scene);
    if (scene->found & SEEN_BADLY)
        return false;
    if (scene->found & SEEN_AROUND)
        find_around(scene);
    if (scene->nodes != NULL)
        in_parallel(work->threads, parts(scene->hierarchy.node_count), see_nodes, scene);
    return true;
}

// ---- the picture ------------------------------------------------------------------------------

typedef struct {
    const Work *work;
    const SeenScene *scene;
    Walk *walk;
    PaintTile *paint;
} Cast;

static int tiles(int pixels)
{
    return (pixels + TILE - 1) / TILE;
}

// Decides a pixel in doubt: step 3, in double.
static void decide(const Cast *cast, Pixel pixel)
{
    const Work *work = cast->work;
    Hit hit = hierarchy_nearest(&cast->scene->hierarchy, work->scene,
                                pixel_ray(work->camera, work->image->size, pixel));
    paint_pixel(work->image, image_index(work->image, pixel), work->scene, cast->scene->paints,
                hit.sphere);
}

static void cast_tile(void *given, int part)
{
    const Cast *cast = given;
    Image *image = cast->work->image;
    int across = tiles(image->size.width);
    Tile tile = {.column = part % across * TILE_BLOCKS, .row = part / across * TILE_BLOCKS};
    cast->walk(&cast->scene->view, &tile);
    int left = tile.column * BLOCK, top = tile.row * BLOCK;
    int right = left + TILE < image->size.width ? left + TILE : image->size.width;
    int bottom = top + TILE < image->size.height ? top + TILE : image->size.height;
    cast->paint(&tile, right - left, bottom - top, image_bytes(image, (Pixel){left, top}),
                3 * (size_t)image->size.width);
    for (int row = top; tile.doubts && row < bottom; row++)
        for (int column = left; column < right; column++)
            if (tile.colors[(row - top) * TILE + column - left] == IN_DOUBT)
                decide(cast, (Pixel){column, row});
}

static bool cast_by(const Work *work, Message *message, Walk *walk, bool wide)
{
    if (extreme_scene(work))
        return cast_extreme(work, message);
    static PaintTile *const paints[LANES_KINDS] = LANES_TABLE(paint_tile);
    SeenScene scene;
    Cast cast = {work, &scene, walk, paints[lanes_best()]};
    Resolution screen = work->image->size;
    bool ready = seen_scene_build(&scene, work, wide);
    if (work->built != NULL)
        *work->built = clock_seconds();
    if (!ready)
        message_set(message, "no memory for a hierarchy of %d spheres", work->scene->sphere_count);
    else if (seen_scene_look(&scene))
        in_parallel(work->threads, tiles(screen.width) * tiles(screen.height), cast_tile, &cast);
    else
        ready = cast_bvh(work, message);
    seen_scene_free(&scene);
    return ready;
}

bool cast_packet(const Work *work, Message *message)
{
    static Walk *const walks[LANES_KINDS] = LANES_TABLE(walk_packets);
    return cast_by(work, message, walks[lanes_best()], false);
}

bool cast_tiles(const Work *work, Message *message)
{
    static Walk *const walks[LANES_KINDS] = LANES_TABLE(walk_frustum);
    return cast_by(work, message, walks[lanes_best()], true);
}
