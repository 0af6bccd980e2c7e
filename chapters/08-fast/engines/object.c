// object.c - step 2: object order. Every sphere asks the pixels of its rectangle, and only those.
//
// This is the deck's first idea. The outline of a sphere on the image plane is an ellipse, and its
// rectangle is exact (covered_pixels.c). For each pixel the t and the sphere of the nearest hit so
// far are kept: a z-buffer.
#include "chapters/08-fast/engines/engine.h"

#include "chapters/08-fast/engines/covered_pixels.h"
#include "chapters/08-fast/engines/number_limits.h"
#include "chapters/08-fast/engines/parallel.h"
#include "chapters/08-fast/engines/sphere_colors.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"

#include <stdlib.h>

enum { BAND = 16 }; // rows that one thread takes at a time

typedef struct {
    const Work *work;
    const Rectangle *rectangles;
    const Paint *paints;
    Hit *nearest;
} ObjectOrder;

static void ask_pixels(const ObjectOrder *order, int sphere, int top, int bottom)
{
    const Work *work = order->work;
    Resolution screen = work->image->size;
    Rectangle box = order->rectangles[sphere];
    for (int row = box.top > top ? box.top : top; row < box.bottom && row < bottom; row++) {
        Hit *nearest = order->nearest + (size_t)row * (size_t)screen.width;
        for (int column = box.left; column < box.right; column++) {
            Ray ray = pixel_ray(work->camera, screen, (Pixel){column, row});
            double t = hit_sphere(ray, work->scene->spheres[sphere]);
            if (t < nearest[column].t)
                nearest[column] = (Hit){t, sphere};
        }
    }
}

static void cast_band(void *given, int band)
{
    const ObjectOrder *order = given;
    const Work *work = order->work;
    int top = band * BAND, bottom = top + BAND;
    if (bottom > work->image->size.height)
        bottom = work->image->size.height;
    int width = work->image->size.width;
    for (size_t i = (size_t)top * (size_t)width; i < (size_t)bottom * (size_t)width; i++)
        order->nearest[i] = (Hit){NO_HIT, -1};
    for (int sphere = 0; sphere < work->scene->sphere_count; sphere++)
        ask_pixels(order, sphere, top, bottom);
    for (size_t i = (size_t)top * (size_t)width; i < (size_t)bottom * (size_t)width; i++)
        paint_pixel(work->image, i, work->scene, order->paints, order->nearest[i].sphere);
}

bool cast_object(const Work *work, Message *message)
{
    if (extreme_scene(work))
        return cast_extreme(work, message);
    Resolution screen = work->image->size;
    int count = work->scene->sphere_count;
    Rectangle *rectangles = malloc(((size_t)count + 1) * sizeof *rectangles);
    Hit *nearest = malloc((size_t)screen.width * (size_t)screen.height * sizeof *nearest);
    Paint *paints = paints_of(work->scene);
    ObjectOrder order = {work, rectangles, paints, nearest};
    bool ready = rectangles != NULL && nearest != NULL && paints != NULL;
    for (int i = 0; ready && i < count; i++)
        rectangles[i] = view_rectangle(work->camera, screen, work->scene->spheres[i]);
    if (ready)
        in_parallel(work->threads, (screen.height + BAND - 1) / BAND, cast_band, &order);
    else
        message_set(message, "no memory for %d x %d pixels and %d spheres", screen.width,
                    screen.height, count);
    free(paints);
    free(nearest);
    free(rectangles);
    return ready;
}
