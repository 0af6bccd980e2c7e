// object.c - step 2: object order. Every sphere asks the pixels of its rectangle, and only those.
//
// This is the deck's first idea. The outline of a sphere on the image plane is an ellipse, and its
// rectangle is exact. For each pixel the t and the sphere of the nearest hit so far are kept: a
// z-buffer.
#include "chapters/08-fast/engines/engine.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/08-fast.h"

#include <stdlib.h>

enum { BAND = 16 }; // rows that one thread takes at a time

// Columns left to right - 1, rows top to bottom - 1; empty if left >= right or top >= bottom.
typedef struct {
    int left, right, top, bottom;
} Rectangle;

static int clamped(double x, int most)
{
    return x > 0 ? x < most ? (int)x : most : 0;
}

// All pixels whose rays may hit the sphere: the rectangle of exercise 08, and one more pixel on
// each side, so that rounding leaves none out.
static Rectangle view_rectangle(Camera camera, Resolution screen, Sphere sphere)
{
    sphere.radius *= 1 + 1e-9; // rounding makes no sphere larger than that
    ScreenRectangle exact = sphere_rectangle(camera, screen, sphere);
    return (Rectangle){
        clamped(exact.left - 1, screen.width), clamped(exact.right + 2, screen.width),
        clamped(exact.top - 1, screen.height), clamped(exact.bottom + 2, screen.height)};
}

typedef struct {
    const Work *work;
    const Rectangle *rectangles;
    const int *colors;
    Hit *nearest;
} ObjectOrder;

static void ask_pixels(const ObjectOrder *order, int sphere, int top, int bottom)
{
    const Work *work = order->work;
    Resolution screen = work->image->size;
    Rectangle box = order->rectangles[sphere];
    for (int row = most(box.top, top); row < least(box.bottom, bottom); row++) {
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
    int top = band * BAND, bottom = least(top + BAND, work->image->size.height);
    const size_t width = (size_t)work->image->size.width;
    const size_t begin = (size_t)top * width, end = (size_t)bottom * width;
    for (size_t i = begin; i < end; i++)
        order->nearest[i] = (Hit){NO_HIT, -1};
    for (int sphere = 0; sphere < work->scene->sphere_count; sphere++)
        ask_pixels(order, sphere, top, bottom);
    for (size_t i = begin; i < end; i++)
        paint_pixel(work->image, i, work->scene, order->colors, order->nearest[i].sphere);
}

bool cast_object(const Work *work, Message *message)
{
    if (extreme_scene(work))
        return cast_extreme(work, message);
    Resolution screen = work->image->size;
    int count = work->scene->sphere_count;
    Rectangle *rectangles = malloc(((size_t)count + 1) * sizeof *rectangles);
    Hit *nearest = malloc((size_t)screen.width * (size_t)screen.height * sizeof *nearest);
    int *colors = colors_of(work->scene);
    ObjectOrder order = {work, rectangles, colors, nearest};
    bool ready = rectangles != NULL && nearest != NULL && colors != NULL;
    for (int i = 0; ready && i < count; i++)
        rectangles[i] = view_rectangle(work->camera, screen, work->scene->spheres[i]);
    if (ready)
        in_parallel(work->threads, (screen.height + BAND - 1) / BAND, cast_band, &order);
    else
        message_set(message, "no memory for %d x %d pixels and %d spheres", screen.width,
                    screen.height, count);
    free(colors);
    free(nearest);
    free(rectangles);
    return ready;
}
