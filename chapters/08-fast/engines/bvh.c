// bvh.c - step 3: a hierarchy of boxes, one ray at a time. Every ray asks the spheres on its way.
//
// The ray enters nearer boxes first, and no box that begins farther away than a hit that was found.
// The spheres are asked as in chapter 05, so the picture is the same to the bit.
#include "chapters/08-fast/engines/engine.h"

#include "chapters/08-fast/engines/clock.h"
#include "chapters/08-fast/engines/nearest_hit.h"
#include "chapters/08-fast/engines/number_limits.h"
#include "chapters/08-fast/engines/parallel.h"
#include "chapters/08-fast/engines/sphere_colors.h"
#include "exercises/04-pixel-ray.h"

#include <stdlib.h>

typedef struct {
    const Work *work;
    const Paint *paints;
    Hierarchy hierarchy;
} ByRay;

static void cast_row(void *given, int row)
{
    const ByRay *by_ray = given;
    const Work *work = by_ray->work;
    Resolution screen = work->image->size;
    for (int column = 0; column < screen.width; column++) {
        Pixel pixel = {column, row};
        Hit hit = hierarchy_nearest(&by_ray->hierarchy, work->scene,
                                    pixel_ray(work->camera, screen, pixel));
        paint_pixel(work->image, image_index(work->image, pixel), work->scene, by_ray->paints,
                    hit.sphere);
    }
}

bool cast_bvh(const Work *work, Message *message)
{
    if (extreme_scene(work))
        return cast_extreme(work, message);
    Paint *paints = paints_of(work->scene);
    ByRay by_ray = {.work = work, .paints = paints};
    bool ready = paints != NULL &&
                 hierarchy_build(&by_ray.hierarchy, work->scene, SMALL_LEAF, work->threads);
    if (work->built != NULL)
        *work->built = clock_seconds();
    if (ready)
        in_parallel(work->threads, work->image->size.height, cast_row, &by_ray);
    else
        message_set(message, "no memory for a hierarchy of %d spheres", work->scene->sphere_count);
    hierarchy_free(&by_ray.hierarchy);
    free(paints);
    return ready;
}
