// mistakes.h - what wrong answers to exercise 06 share: a picture cast with slips.
//
// One way to cast, in object order. Each place where people slip is a member of Slips; members that
// are not set are right. Image order is the same with its own depth.
#ifndef TESTS_06_RAY_CASTING_MISTAKES_H
#define TESTS_06_RAY_CASTING_MISTAKES_H

#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"
#include "tests/judge/mistake.h"

#include <stdlib.h>

extern const Mistake nearest_mistakes[], nearest_limit_mistakes[], picture_limit_mistakes[],
    image_order_mistakes[], object_order_mistakes[], depth_mistakes[], color_mistakes[];

// ---- where a sphere is hit ----------------------------------------------------------------------

static inline double near_root(Ray ray, Sphere sphere)
{
    Roots roots = sphere_roots(ray, sphere);
    return roots.count > 0 ? roots.t[0] : NO_HIT;
}

static inline double near_root_in_front(Ray ray, Sphere sphere)
{
    double t = near_root(ray, sphere);
    return t > 0 ? t : NO_HIT;
}

static inline double far_root(Ray ray, Sphere sphere)
{
    Roots roots = sphere_roots(ray, sphere);
    return roots.count > 0 && roots.t[1] > 0 ? roots.t[1] : NO_HIT;
}

static inline double hit_beyond(double least, Ray ray, Sphere sphere)
{
    double t = hit_sphere(ray, sphere);
    return t > least ? t : NO_HIT;
}

static inline double hit_beyond_the_plane(Ray ray, Sphere sphere)
{
    return hit_beyond(1, ray, sphere);
}

static inline double hit_as_float(Ray ray, Sphere sphere)
{
    return (float)hit_sphere(ray, sphere);
}

// ---- which hit replaces the best so far ---------------------------------------------------------

static inline bool nearer(double t, double best)
{
    return t < best;
}

static inline bool nearer_or_equal(double t, double best)
{
    return t < NO_HIT && t <= best;
}

static inline bool any_hit(double t, double best)
{
    (void)best;
    return t < NO_HIT;
}

static inline bool hit_and_none_before(double t, double best)
{
    return t < NO_HIT && best == NO_HIT;
}

static inline bool hit_and_farther(double t, double best)
{
    return t < NO_HIT && (best == NO_HIT || t > best);
}

// ---- whose ray, and what colour -----------------------------------------------------------------

static inline Pixel row_from_below(Pixel pixel, Resolution size)
{
    return (Pixel){pixel.column, size.height - 1 - pixel.row};
}

static inline Pixel column_from_the_right(Pixel pixel, Resolution size)
{
    return (Pixel){size.width - 1 - pixel.column, pixel.row};
}

static inline Pixel row_and_column_swapped(Pixel pixel, Resolution size)
{
    (void)size;
    return (Pixel){pixel.row, pixel.column};
}

static inline bool in_last_column(Pixel pixel, Resolution size)
{
    return pixel.column == size.width - 1;
}

static inline bool in_last_row(Pixel pixel, Resolution size)
{
    return pixel.row == size.height - 1;
}

// Of a sphere, or of -1, the background.
static inline Color flat_color(const Scene *scene, int sphere)
{
    return sphere < 0 ? scene->background : scene_surface(scene, sphere)->color;
}

// ---- casting ------------------------------------------------------------------------------------

typedef struct {
    double (*t_of)(Ray ray, Sphere sphere);
    bool (*replaces)(double t, double best);
    Pixel (*ray_of)(Pixel pixel, Resolution size); // the pixel whose ray is used
    Color (*color)(const Scene *scene, int sphere);
    bool (*left_out)(Pixel pixel, Resolution size);
    bool one_pass;                 // pixels that are left out do not get a background either
    bool no_background;            // it is never painted
    bool background_where_missed;  // by each sphere
    bool background_where_farther; // by each sphere, if it is not painted itself
    int first_sphere, last_sphere; // how many are left out
    int (*place)(Pixel pixel, Resolution size); // in depth
    bool depth_kept;                            // not set before the loops
    bool depth_starts_elsewhere;                // at this number:
    double depth_start;
    bool depth_not_stored;
} Slips;

static inline Pixel pixel_number(int i, Resolution size)
{
    return (Pixel){i % size.width, i / size.width};
}

static inline int row_by_row(Pixel pixel, Resolution size)
{
    return pixel.row * size.width + pixel.column;
}

static inline bool is_left_out(const Slips *slips, Pixel pixel, Resolution size)
{
    return slips->left_out != NULL && slips->left_out(pixel, size);
}

static inline Color color_of(const Slips *slips, const Scene *scene, int sphere)
{
    return (slips->color != NULL ? slips->color : flat_color)(scene, sphere);
}

static inline void cast_nothing(const Slips *slips, const Scene *scene, Image *image, double *depth)
{
    for (int i = 0; i < image->size.width * image->size.height; i++) {
        Pixel pixel = pixel_number(i, image->size);
        if (!slips->depth_kept)
            depth[i] = slips->depth_starts_elsewhere ? slips->depth_start : NO_HIT;
        if (!slips->no_background && !(slips->one_pass && is_left_out(slips, pixel, image->size)))
            image_set(image, pixel, color_of(slips, scene, -1));
    }
}

static inline void cast_sphere(const Slips *slips, const Scene *scene, int sphere, Camera camera,
                               Image *image, double *depth)
{
    Resolution size = image->size;
    for (int i = 0; i < size.width * size.height; i++) {
        Pixel pixel = pixel_number(i, size);
        if (is_left_out(slips, pixel, size))
            continue;
        Pixel other = slips->ray_of != NULL ? slips->ray_of(pixel, size) : pixel;
        double t = (slips->t_of != NULL ? slips->t_of : hit_sphere)(pixel_ray(camera, size, other),
                                                                    scene->spheres[sphere]);
        double *best = &depth[(slips->place != NULL ? slips->place : row_by_row)(pixel, size)];
        if ((slips->replaces != NULL ? slips->replaces : nearer)(t, *best)) {
            image_set(image, pixel, color_of(slips, scene, sphere));
            if (!slips->depth_not_stored)
                *best = t;
        } else if (slips->background_where_farther ||
                   (slips->background_where_missed && !(t < NO_HIT))) {
            image_set(image, pixel, scene->background);
        }
    }
}

static inline void cast_with(Slips slips, const Scene *scene, Camera camera, Image *image,
                             double *depth)
{
    cast_nothing(&slips, scene, image, depth);
    for (int i = slips.first_sphere; i < scene->sphere_count - slips.last_sphere; i++)
        cast_sphere(&slips, scene, i, camera, image, depth);
}

#define OBJECT_ORDER(name, ...)                                                                    \
    static void name(const Scene *scene, Camera camera, Image *image, double *depth)               \
    {                                                                                              \
        cast_with((Slips){__VA_ARGS__}, scene, camera, image, depth);                              \
    }

static inline double *depth_for(const Image *image)
{
    double *depth = calloc((size_t)image->size.width * (size_t)image->size.height, sizeof *depth);
    if (depth == NULL)
        abort();
    return depth;
}

#define IMAGE_ORDER(name, ...)                                                                     \
    static void name(const Scene *scene, Camera camera, Image *image)                              \
    {                                                                                              \
        double *depth = depth_for(image);                                                          \
        cast_with((Slips){.one_pass = true, __VA_ARGS__}, scene, camera, image, depth);            \
        free(depth);                                                                               \
    }

#endif
