// plain.c - step 1: chapter 06's loop. Every pixel asks every sphere.
//
// All other engines are compared with this one. Compared with chapter 06, only threads that share
// the rows are new.
#include "chapters/08-fast/engines/engine.h"

#include "chapters/08-fast/engines/parallel.h"
#include "chapters/08-fast/engines/sphere_colors.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/06-ray-casting.h"

#include <pthread.h>
#include <stdlib.h>

typedef struct {
    const Work *work;
    const Paint *paints;
    pthread_mutex_t *together; // for the count of pixels
} Plain;

static void cast_row(void *given, int row)
{
    const Plain *plain = given;
    const Work *work = plain->work;
    Resolution screen = work->image->size;
    for (int column = 0; column < screen.width; column++) {
        Pixel pixel = {column, row};
        Hit hit = nearest_hit(pixel_ray(work->camera, screen, pixel), work->scene);
        paint_pixel(work->image, image_index(work->image, pixel), work->scene, plain->paints,
                    hit.sphere);
    }
    pthread_mutex_lock(plain->together);
    work->image->set_count += screen.width;
    if (work->image->progress != NULL)
        work->image->progress(work->image);
    pthread_mutex_unlock(plain->together);
}

bool cast_plain(const Work *work, Message *message)
{
    Paint *paints = paints_of(work->scene);
    pthread_mutex_t together = PTHREAD_MUTEX_INITIALIZER;
    Plain plain = {work, paints, &together};
    if (paints == NULL)
        return message_set(message, "no memory for %d colours", work->scene->surface_count);
    in_parallel(work->threads, work->image->size.height, cast_row, &plain);
    free(paints);
    return true;
}

bool cast_extreme(const Work *work, Message *message)
{
    if (work->extreme != NULL)
        work->extreme();
    return cast_plain(work, message);
}
