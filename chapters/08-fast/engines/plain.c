// plain.c - step 1: chapter 06's loop. Every pixel asks every sphere.
//
// All other engines are compared with this one. Compared with chapter 06, only threads that share
// the rows are new.
#include "chapters/08-fast/engines/engine.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/06-ray-casting.h"

#include <pthread.h>
#include <stdlib.h>

typedef struct {
    const Work *work;
    const int *colors;
    Nearest *nearest;
    const void *of;
} Casting;

void rows_are_done(Image *image, int rows)
{
    static pthread_mutex_t together = PTHREAD_MUTEX_INITIALIZER;
    pthread_mutex_lock(&together);
    image->set_count += (long)rows * image->size.width;
    if (image->progress != NULL)
        image->progress(image);
    pthread_mutex_unlock(&together);
}

static void cast_row(void *given, int row)
{
    const Casting *casting = given;
    const Work *work = casting->work;
    Resolution screen = work->image->size;
    for (int column = 0; column < screen.width; column++) {
        Pixel pixel = {column, row};
        Hit hit =
            casting->nearest(casting->of, work->scene, pixel_ray(work->camera, screen, pixel));
        paint_pixel(work->image, image_index(work->image, pixel), work->scene, casting->colors,
                    hit.sphere);
    }
    rows_are_done(work->image, 1);
}

bool cast_rays(const Work *work, Nearest *nearest, const void *of, Message *message)
{
    int *colors = colors_of(work->scene);
    Casting casting = {work, colors, nearest, of};
    if (colors == NULL)
        return message_set(message, "no memory for %d colors", work->scene->surface_count);
    in_parallel(work->threads, work->image->size.height, cast_row, &casting);
    free(colors);
    return true;
}

static Hit ask_all(const void *of, const Scene *scene, Ray ray)
{
    (void)of;
    return nearest_hit(ray, scene);
}

bool cast_plain(const Work *work, Message *message)
{
    return cast_rays(work, ask_all, NULL, message);
}

bool cast_extreme(const Work *work, Message *message)
{
    if (work->extreme != NULL)
        work->extreme();
    return cast_plain(work, message);
}

// ---- colors ----------------------------------------------------------------------------------

int *colors_of(const Scene *scene)
{
    int *colors = malloc(((size_t)scene->surface_count + 1) * sizeof *colors);
    for (int i = 0; colors != NULL && i <= scene->surface_count; i++) {
        Color from = i < scene->surface_count ? scene->surfaces[i].color : scene->background;
        colors[i] = byte_from_color(from[0]) | byte_from_color(from[1]) << 8 |
                    byte_from_color(from[2]) << 16;
    }
    return colors;
}

// ---- extreme numbers --------------------------------------------------------------------------

static bool extreme_length(double x)
{
    return !(x >= 1 / EXTREME_LENGTH && x <= EXTREME_LENGTH);
}

static bool extreme_place(vec3 place)
{
    return !(fabs(place[0]) <= EXTREME_LENGTH && fabs(place[1]) <= EXTREME_LENGTH &&
             fabs(place[2]) <= EXTREME_LENGTH);
}

bool extreme_camera(Camera camera, Resolution screen)
{
    double finest = FINEST_PIXEL * camera.distance;
    return extreme_place(camera.origin) || extreme_length(camera.distance) ||
           extreme_length(camera.width) || extreme_length(camera.height) ||
           camera.width < finest * screen.width || camera.height < finest * screen.height;
}

bool extreme_scene(const Work *work)
{
    bool extreme = extreme_camera(work->camera, work->image->size);
    for (int i = 0; i < work->scene->sphere_count; i++) {
        const Sphere *sphere = &work->scene->spheres[i];
        double distance = vec3_length(sphere->center - work->camera.origin);
        extreme |= extreme_place(sphere->center) || extreme_length(sphere->radius) ||
                   !(distance <= EXTREME_RADII * sphere->radius);
    }
    return extreme;
}

bool extreme_light(const Work *work)
{
    const Scene *scene = work->scene;
    // The smallest radius; how far spheres reach from the eye, and rays start from their spheres
    // (offset_from_surface).
    double smallest = INFINITY, farthest = 0, off = 0;
    for (int i = 0; i < scene->sphere_count; i++) {
        const Sphere *sphere = &scene->spheres[i];
        double r = sphere->radius;
        smallest = fmin(smallest, r);
        farthest = fmax(farthest, vec3_length(sphere->center - work->camera.origin) + r);
        off = fmax(off, 0x1p-30 * (vec3_length(sphere->center) + r));
    }
    bool extreme = extreme_scene(work) || farthest + off > EXTREME_RADII_OF_LIGHT * smallest;
    for (int i = 0; i < scene->light_count; i++) {
        const Light *light = &scene->lights[i];
        extreme |= extreme_place(light->position) ||
                   (light->kind == LIGHT_DISTANT && extreme_length(vec3_length(light->position)));
    }
    return extreme;
}
