// shading.c - chapter 07's pictures: shadows and mirrors. Every ray asks every sphere (plain), or
// the spheres on its way (bvh).
#include "chapters/08-fast/engines/engine.h"

#include "chapters/08-fast/engines/clock.h"
#include "chapters/08-fast/engines/number_limits.h"
#include "chapters/08-fast/engines/parallel.h"
#include "chapters/08-fast/engines/path_spheres.h"

#include <pthread.h>

typedef struct {
    const Work *work;
    Rendering rendering;
    const Hierarchy *hierarchy; // NULL: none
    pthread_mutex_t together;
    bool short_of_memory;
} Lit;

// Other threads write other rows at the same time, so image_set cannot be used.
static void set_pixel(Image *image, Pixel pixel, Color color)
{
    uint8_t *rgb = image_bytes(image, pixel);
    for (int i = 0; i < 3; i++)
        rgb[i] = byte_from_color(color[i]);
}

static void render_row(Lit *lit, void *world, int row)
{
    Image *image = lit->work->image;
    for (int column = 0; column < image->size.width; column++) {
        Pixel pixel = {column, row};
        set_pixel(image, pixel, render_pixel(&lit->rendering, world, pixel));
    }
    pthread_mutex_lock(&lit->together);
    image->set_count += image->size.width;
    if (image->progress != NULL)
        image->progress(image);
    pthread_mutex_unlock(&lit->together);
}

static void row_by_all(void *given, int row)
{
    Lit *lit = given;
    Scene scene = *lit->work->scene;
    render_row(lit, &scene, row);
}

static void row_by_few(void *given, int row)
{
    Lit *lit = given;
    Few few;
    if (few_begin(&few, lit->hierarchy, lit->work->scene, lit->rendering.style.depth)) {
        render_row(lit, &few, row);
        few_end(&few);
    } else {
        pthread_mutex_lock(&lit->together);
        lit->short_of_memory = true;
        pthread_mutex_unlock(&lit->together);
    }
}

bool light_plain(const Work *work, Style style, Message *message)
{
    (void)message;
    Lit lit = {.work = work, .rendering = {work->camera, work->image->size, style, trace_scene}};
    pthread_mutex_init(&lit.together, NULL);
    in_parallel(work->threads, work->image->size.height, row_by_all, &lit);
    pthread_mutex_destroy(&lit.together);
    return true;
}

bool light_bvh(const Work *work, Style style, Message *message)
{
    if (extreme_light(work))
        return light_plain(work, style, message);
    Hierarchy hierarchy;
    Lit lit = {.work = work, .rendering = {work->camera, work->image->size, style, trace_few}};
    lit.hierarchy = &hierarchy;
    bool ready = hierarchy_build(&hierarchy, work->scene);
    if (work->built != NULL)
        *work->built = clock_seconds();
    pthread_mutex_init(&lit.together, NULL);
    if (ready)
        in_parallel(work->threads, work->image->size.height, row_by_few, &lit);
    pthread_mutex_destroy(&lit.together);
    hierarchy_free(&hierarchy);
    if (ready && !lit.short_of_memory)
        return true;
    return message_set(message, "no memory for a hierarchy of %d spheres",
                       work->scene->sphere_count);
}
