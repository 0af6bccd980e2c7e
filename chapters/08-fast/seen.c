// seen.c - steps 4 and 5: what they share. The scene becomes floats, tiles of pixels are walked,
// and what is left in doubt is decided by step 3.
#include "chapters/08-fast/seen.h"

#include "chapters/08-fast/clock.h"
#include "chapters/08-fast/engine.h"
#include "chapters/08-fast/nearest.h"
#include "chapters/08-fast/paint.h"
#include "chapters/08-fast/parallel.h"
#include "exercises/04-pixel-ray.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

enum { AT_A_TIME = 64 * SEEN_AT_ONCE }; // spheres or nodes, by one thread

typedef struct {
    const Work *work;
    Hierarchy hierarchy;
    const Paint *paints;
    Unseen *unseen;
    Seen *seen;
    SeenNode *nodes;
    WideNode *wide;
    int *around;
    atomic_int found;
    int *colors; // of the spheres in the order of the hierarchy
    View view;
    See *see;
    Walk *walk;
    PaintTile *paint;
} Cast;

static int parts(int of, int at_a_time)
{
    return of / at_a_time + (of % at_a_time > 0);
}

// ---- the scene as floats ----------------------------------------------------------------------

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
    Cast *cast = given;
    const Scene *scene = cast->work->scene;
    int begin = part * AT_A_TIME, end = begin + AT_A_TIME;
    int padded = parts(scene->sphere_count, SEEN_AT_ONCE) * SEEN_AT_ONCE;
    for (int i = begin; i < end && i < padded; i++) {
        // What fills up the last 64 is never asked for.
        int place = i < scene->sphere_count ? i : 0;
        const Sphere *sphere = &scene->spheres[cast->hierarchy.order[place]];
        Unseen *unseen = &cast->unseen[i / SEEN_AT_ONCE];
        unseen->x[i % SEEN_AT_ONCE] = sphere->center[0];
        unseen->y[i % SEEN_AT_ONCE] = sphere->center[1];
        unseen->z[i % SEEN_AT_ONCE] = sphere->center[2];
        unseen->radius[i % SEEN_AT_ONCE] = sphere->radius;
        cast->colors[i] = color_of(cast->paints[sphere->surface]);
    }
}

static void see_spheres(void *given, int part)
{
    Cast *cast = given;
    int begin = part * AT_A_TIME, end = begin + AT_A_TIME, found = 0;
    for (int i = begin; i < end && i < cast->work->scene->sphere_count; i += SEEN_AT_ONCE)
        found |= cast->see(&cast->view, &cast->unseen[i / SEEN_AT_ONCE], &cast->seen[i]);
    atomic_fetch_or(&cast->found, found);
}

// Boxes as floats, from the eye, a little larger (SeenNode).
static void see_nodes(void *given, int part)
{
    Cast *cast = given;
    const Hierarchy *hierarchy = &cast->hierarchy;
    int begin = part * AT_A_TIME, end = begin + AT_A_TIME;
    for (int i = begin; i < end && i < hierarchy->node_count; i++) {
        const Node *node = &hierarchy->nodes[i];
        double low[3], high[3], reach = 0;
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = node->box.low[axis] - cast->view.eye[axis];
            high[axis] = node->box.high[axis] - cast->view.eye[axis];
            reach = -low[axis] > reach ? -low[axis] : reach;
            reach = high[axis] > reach ? high[axis] : reach;
        }
        SeenNode *seen = &cast->nodes[i];
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

// The spheres that the eye is in: every ray hits them, so they have no outline.
static void find_around(Cast *cast)
{
    for (int i = 0; i < cast->work->scene->sphere_count; i++) {
        const Seen *seen = &cast->seen[i];
        float squared = seen->x * seen->x + seen->y * seen->y + seen->z * seen->z;
        if (squared < seen->smaller)
            cast->around[cast->view.around_count++] = i;
    }
}

static void store(double *into, vec3 v)
{
    for (int i = 0; i < 3; i++)
        into[i] = v[i];
}

static void set_view(Cast *cast, float *x, float *y)
{
    Camera camera = cast->work->camera;
    Resolution screen = cast->work->image->size;
    double width = camera.width / camera.distance, height = camera.height / camera.distance;
    View *view = &cast->view;
    *view = (View){.nodes = cast->nodes,
                   .wide = cast->wide,
                   .seen = cast->seen,
                   .colors = cast->colors,
                   .background = color_of(cast->paints[cast->work->scene->surface_count]),
                   .around = cast->around,
                   .scale_x = screen.width / width,
                   .scale_y = screen.height / height,
                   .middle_x = screen.width / 2.0,
                   .middle_y = screen.height / 2.0,
                   .columns = (screen.width + BLOCK - 1) / BLOCK,
                   .rows = (screen.height + BLOCK - 1) / BLOCK,
                   .x = x,
                   .y = y};
    store(view->eye, camera.origin);
    store(view->right, camera.right);
    store(view->up, camera.up);
    store(view->ahead, camera.forward);
    for (int i = 0; i < screen.width + TILE; i++)
        x[i] = (float)(((i + 0.5) / screen.width - 0.5) * width);
    for (int i = 0; i < screen.height + TILE; i++)
        y[i] = (float)((0.5 - (i + 0.5) / screen.height) * height);
}

// ---- tiles ------------------------------------------------------------------------------------

// What is in doubt: step 3, in double.
static void decide(const Cast *cast, Pixel pixel)
{
    const Work *work = cast->work;
    Hit hit = hierarchy_nearest(&cast->hierarchy, work->scene,
                                pixel_ray(work->camera, work->image->size, pixel));
    size_t place = (size_t)pixel.row * (size_t)work->image->size.width + (size_t)pixel.column;
    paint_pixel(work->image, place, work->scene, cast->paints, hit.sphere);
}

static void cast_tile(void *given, int part)
{
    const Cast *cast = given;
    Image *image = cast->work->image;
    int across = parts(image->size.width, TILE);
    Tile tile = {.column = part % across * TILE_BLOCKS, .row = part / across * TILE_BLOCKS};
    cast->walk(&cast->view, &tile);
    int left = tile.column * BLOCK, top = tile.row * BLOCK;
    int right = left + TILE < image->size.width ? left + TILE : image->size.width;
    int bottom = top + TILE < image->size.height ? top + TILE : image->size.height;
    size_t place = (size_t)top * (size_t)image->size.width + (size_t)left;
    cast->paint(&tile, right - left, bottom - top, image->rgb + 3 * place,
                3 * (size_t)image->size.width);
    for (int row = top; tile.doubts && row < bottom; row++)
        for (int column = left; column < right; column++)
            if (tile.colors[(row - top) * TILE + column - left] == IN_DOUBT)
                decide(cast, (Pixel){column, row});
}

// ---- both -------------------------------------------------------------------------------------

// False where floats will not do: see SEEN_BADLY; and for rays nearly at right angles to the view.
static bool cast_in_floats(Cast *cast, float *x, float *y)
{
    const Work *work = cast->work;
    Camera camera = work->camera;
    if (camera.width > 500 * camera.distance || camera.height > 500 * camera.distance)
        return false;
    set_view(cast, x, y);
    in_parallel(work->threads, parts(work->scene->sphere_count, AT_A_TIME), see_spheres, cast);
    if (cast->found & SEEN_BADLY)
        return false;
    if (cast->found & SEEN_AROUND)
        find_around(cast);
    if (cast->nodes != NULL)
        in_parallel(work->threads, parts(cast->hierarchy.node_count, AT_A_TIME), see_nodes, cast);
    Resolution screen = work->image->size;
    in_parallel(work->threads, parts(screen.width, TILE) * parts(screen.height, TILE), cast_tile,
                cast);
    return true;
}

static bool cast_by(const Work *work, Message *message, Walk *walk, bool wide)
{
    static See *const sees[LANES_KINDS] = LANES_TABLE(see);
    static PaintTile *const paint_tiles[LANES_KINDS] = LANES_TABLE(paint_tile);
    size_t count = (size_t)work->scene->sphere_count;
    Cast cast = {
        .work = work, .walk = walk, .see = sees[lanes_best()], .paint = paint_tiles[lanes_best()]};
    Paint *paints = paints_of(work->scene);
    float *x = malloc(((size_t)work->image->size.width + TILE) * sizeof *x);
    float *y = malloc(((size_t)work->image->size.height + TILE) * sizeof *y);
    cast.paints = paints;
    cast.unseen = malloc((count / SEEN_AT_ONCE + 1) * sizeof *cast.unseen);
    cast.seen = malloc((count + SEEN_AT_ONCE) * sizeof *cast.seen);
    cast.colors = malloc((count + SEEN_AT_ONCE) * sizeof *cast.colors);
    cast.around = malloc((count + 1) * sizeof *cast.around);
    bool ready = paints != NULL && x != NULL && y != NULL && cast.unseen != NULL &&
                 cast.seen != NULL && cast.colors != NULL && cast.around != NULL &&
                 hierarchy_build(&cast.hierarchy, work->scene);
    if (ready && count > 0 && wide) {
        cast.wide = wide_build(&cast.hierarchy);
        ready = cast.wide != NULL;
    } else if (ready && count > 0) {
        cast.nodes = malloc((size_t)cast.hierarchy.node_count * sizeof *cast.nodes);
        ready = cast.nodes != NULL;
    }
    if (ready)
        in_parallel(work->threads, parts(work->scene->sphere_count, AT_A_TIME), line_up, &cast);
    if (work->built != NULL)
        *work->built = clock_seconds();
    if (!ready)
        message_set(message, "no memory for a hierarchy of %d spheres", work->scene->sphere_count);
    else if (!cast_in_floats(&cast, x, y))
        ready = cast_bvh(work, message);
    free(cast.nodes);
    free(cast.wide);
    free(cast.around);
    free(cast.colors);
    free(cast.seen);
    free(cast.unseen);
    free(y);
    free(x);
    hierarchy_free(&cast.hierarchy);
    free(paints);
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
