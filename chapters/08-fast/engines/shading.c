// shading.c - chapter 07's pictures: shadows and mirrors. Every ray asks every sphere (plain), or
// the spheres on its way (bvh).
#include "chapters/08-fast/engines/engine.h"

#include "chapters/08-fast/engines/clock.h"
#include "chapters/08-fast/engines/large_memory.h"
#include "chapters/08-fast/engines/light_paths.h"
#include "chapters/08-fast/engines/number_limits.h"
#include "chapters/08-fast/engines/parallel.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    const Work *work;
    Rendering rendering;
    const LightWorld *world; // NULL: none
    int *seen;               // the sphere that each sample sees, row by row; NULL: not known
    uint8_t background[3];   // of a pixel whose samples see nothing
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

static void row_is_done(Lit *lit)
{
    Image *image = lit->work->image;
    pthread_mutex_lock(&lit->together);
    image->set_count += image->size.width;
    if (image->progress != NULL)
        image->progress(image);
    pthread_mutex_unlock(&lit->together);
}

static void row_by_all(void *given, int row)
{
    Lit *lit = given;
    Image *image = lit->work->image;
    Scene scene = *lit->work->scene;
    for (int column = 0; column < image->size.width; column++) {
        Pixel pixel = {column, row};
        set_pixel(image, pixel, render_pixel(&lit->rendering, &scene, pixel));
    }
    row_is_done(lit);
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

// ---- by the hierarchy -------------------------------------------------------------------------

static Resolution samples_of(const Rendering *rendering)
{
    int n = rendering->style.samples;
    return (Resolution){rendering->screen.width * n, rendering->screen.height * n};
}

// The bins find the spheres that are seen from the eye. If they cannot, the rays ask the hierarchy.
static void look(Lit *lit)
{
    enum { MOST_PLACES = 60000 }; // a place on the screen has 16 bits
    Resolution samples = samples_of(&lit->rendering);
    size_t count = (size_t)samples.width * (size_t)samples.height;
    if (samples.width > MOST_PLACES || samples.height > MOST_PLACES)
        return;
    Image size = {.size = samples};
    Work work = *lit->work;
    work.image = &size;
    lit->seen = large_memory(count * sizeof *lit->seen);
    if (lit->seen != NULL && !bins_spheres(&work, lit->seen)) {
        free(lit->seen);
        lit->seen = NULL;
    }
}

static Color see_background(void *world, Pixel sample, Ray ray, int depth)
{
    const Lit *lit = world;
    (void)sample, (void)ray, (void)depth;
    return lit->work->scene->background;
}

static void set_background(Lit *lit)
{
    Rendering empty = lit->rendering;
    Image pixel = {.size = {1, 1}, .rgb = lit->background};
    empty.trace = see_background;
    set_pixel(&pixel, (Pixel){0, 0}, render_pixel(&empty, lit, (Pixel){0, 0}));
}

// Whether no sample of a pixel sees a sphere.
static bool sees_nothing(const Lit *lit, Pixel pixel)
{
    int n = lit->rendering.style.samples;
    size_t columns = (size_t)samples_of(&lit->rendering).width;
    const int *seen = lit->seen + (size_t)pixel.row * (size_t)n * columns + pixel.column * n;
    for (int row = 0; row < n; row++)
        for (int column = 0; column < n; column++)
            if (seen[(size_t)row * columns + (size_t)column] >= 0)
                return false;
    return true;
}

static void row_by_paths(void *given, int row)
{
    Lit *lit = given;
    Image *image = lit->work->image;
    LightPaths paths;
    if (!light_paths_begin(&paths, lit->world, lit->seen, samples_of(&lit->rendering).width)) {
        pthread_mutex_lock(&lit->together);
        lit->short_of_memory = true;
        pthread_mutex_unlock(&lit->together);
        return;
    }
    for (int column = 0; column < image->size.width; column++) {
        Pixel pixel = {column, row};
        if (lit->seen != NULL && sees_nothing(lit, pixel))
            memcpy(image_bytes(image, pixel), lit->background, sizeof lit->background);
        else
            set_pixel(image, pixel, render_pixel(&lit->rendering, &paths, pixel));
    }
    light_paths_end(&paths);
    row_is_done(lit);
}

bool light_bvh(const Work *work, Style style, Message *message)
{
    if (extreme_light(work))
        return light_plain(work, style, message);
    LightWorld world;
    Lit lit = {.work = work,
               .rendering = {work->camera, work->image->size, style, trace_path},
               .world = &world};
    bool ready = light_world_build(&world, work->scene, work->threads);
    if (work->built != NULL)
        *work->built = clock_seconds();
    pthread_mutex_init(&lit.together, NULL);
    if (ready) {
        look(&lit);
        set_background(&lit);
        in_parallel(work->threads, work->image->size.height, row_by_paths, &lit);
    }
    pthread_mutex_destroy(&lit.together);
    free(lit.seen);
    light_world_free(&world);
    if (ready && !lit.short_of_memory)
        return true;
    return message_set(message, "no memory for a hierarchy of %d spheres",
                       work->scene->sphere_count);
}
