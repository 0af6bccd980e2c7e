// float_bounds.c - the common part of steps 4 and 5. They cast tiles of pixels in floats
// (float_scene.c converts the scene), and step 3 decides the pixels in doubt.
#include "chapters/08-fast/engines/float_bounds.h"

#include "chapters/08-fast/engines/clock.h"
#include "chapters/08-fast/engines/engine.h"
#include "chapters/08-fast/engines/float_scene.h"
#include "chapters/08-fast/engines/nearest_hit.h"
#include "chapters/08-fast/engines/number_limits.h"
#include "chapters/08-fast/engines/parallel.h"
#include "exercises/04-pixel-ray.h"

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
