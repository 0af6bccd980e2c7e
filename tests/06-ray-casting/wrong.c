// wrong.c - wrong answers to exercise 06.
#include "exercises/01-corners.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"

#include "tests/judge/known.h"
#include "tests/judge/numbers.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

// ---- the parts of an answer that may be wrong ---------------------------------------------------

// Where a sphere is hit.
#define T_OF(name, ...)                                                                            \
    static double name(Ray ray, Sphere sphere)                                                     \
    {                                                                                              \
        double t = hit_sphere(ray, sphere);                                                        \
        return __VA_ARGS__;                                                                        \
    }
#define T_OF_ROOTS(name, ...)                                                                      \
    static double name(Ray ray, Sphere sphere)                                                     \
    {                                                                                              \
        Roots roots = sphere_roots(ray, sphere);                                                   \
        return __VA_ARGS__;                                                                        \
    }
#define T_BEYOND(name, least) T_OF(name, t > (least) ? t : NO_HIT)
#define T_BELOW(name, most) T_OF(name, t < (most) ? t : NO_HIT)

T_OF(hit_as_float, (float)t)
T_BEYOND(hit_beyond_the_plane, 1)
T_BEYOND(hit_beyond_a_tenth, 0.1)
T_BEYOND(hit_beyond_a_thousandth, 1e-3)
T_OF_ROOTS(near_root, roots.count > 0 ? roots.t[0] : NO_HIT)
T_OF_ROOTS(near_root_in_front, roots.count > 0 && roots.t[0] > 0 ? roots.t[0] : NO_HIT)
T_OF_ROOTS(far_root, roots.count > 0 && roots.t[1] > 0 ? roots.t[1] : NO_HIT)

// Which hit replaces the best so far.
#define REPLACES(name, ...)                                                                        \
    static bool name(double t, double best)                                                        \
    {                                                                                              \
        (void)best;                                                                                \
        return __VA_ARGS__;                                                                        \
    }

REPLACES(nearer, t < best)
REPLACES(nearer_or_equal, t < NO_HIT && t <= best)
REPLACES(nearer_as_floats, (float)t < (float)best)
REPLACES(any_hit, t < NO_HIT)
REPLACES(hit_and_none_before, t < NO_HIT && best == NO_HIT)
REPLACES(hit_and_farther, t < NO_HIT && (best == NO_HIT || t > best))
REPLACES(hit_and_more, t<NO_HIT && t> best)
REPLACES(more, t > best)

// Whose ray a pixel gets.
#define RAY_OF(name, ...)                                                                          \
    static Ray name(Camera camera, Resolution size, Pixel pixel)                                   \
    {                                                                                              \
        __VA_ARGS__;                                                                               \
    }
#define RAY_OF_PIXEL(name, ...)                                                                    \
    RAY_OF(name, (void)pixel; return pixel_ray(camera, size, (Pixel){__VA_ARGS__}))
#define RAY_THROUGH(name, s, t)                                                                    \
    RAY_OF(name, return (Ray){camera.origin, image_plane_vector(camera, s, t)})
#define RAY_OF_CAMERA(name, ...) RAY_OF(name, __VA_ARGS__; return pixel_ray(camera, size, pixel))

RAY_OF_PIXEL(row_from_below, pixel.column, size.height - 1 - pixel.row)
RAY_OF_PIXEL(column_from_the_right, size.width - 1 - pixel.column, pixel.row)
RAY_OF_PIXEL(row_and_column_swapped, pixel.row, pixel.column)
RAY_OF_PIXEL(turned, size.width - 1 - pixel.column, size.height - 1 - pixel.row)
RAY_OF_PIXEL(next_one, pixel.column + 1, pixel.row + 1)
RAY_OF_PIXEL(always_the_first, 0, 0)
RAY_OF(width_and_height_swapped,
       return pixel_ray(camera, (Resolution){size.height, size.width}, pixel))
RAY_THROUGH(through_corner, (double)pixel.column / size.width, 1 - (double)pixel.row / size.height)
RAY_THROUGH(through_lower_right, (pixel.column + 1.0) / size.width,
            1 - (pixel.row + 1.0) / size.height)
RAY_THROUGH(through_width_less_1, (double)pixel.column / (size.width - 1),
            1 - (double)pixel.row / (size.height - 1))
RAY_OF_CAMERA(from_the_worlds_origin, camera.origin = vec3_of(0, 0, 0))
RAY_OF_CAMERA(height_of_the_shape, camera.height = camera.width * size.height / size.width)
RAY_OF_CAMERA(width_of_the_shape, camera.width = camera.height * size.width / size.height)
RAY_OF_CAMERA(plane_1_away, camera.distance = 1)

// Which pixels are not painted, and where the depth of a pixel is.
#define LEFT_OUT(name, ...) OF_PIXEL(bool, name, __VA_ARGS__)
#define PLACE(name, ...) OF_PIXEL(int, name, __VA_ARGS__)
#define OF_PIXEL(type, name, ...)                                                                  \
    static type name(Pixel pixel, Resolution size)                                                 \
    {                                                                                              \
        (void)pixel, (void)size;                                                                   \
        return __VA_ARGS__;                                                                        \
    }

LEFT_OUT(in_first_column, pixel.column == 0)
LEFT_OUT(in_first_row, pixel.row == 0)
LEFT_OUT(in_last_column, pixel.column == size.width - 1)
LEFT_OUT(in_last_row, pixel.row == size.height - 1)
PLACE(row_by_row, pixel.column + pixel.row * size.width)
PLACE(column_by_column, pixel.row + pixel.column * size.height)
PLACE(from_the_bottom, (size.height - 1 - pixel.row) * size.width + pixel.column)
PLACE(times_the_height, pixel.column + pixel.row * size.height)
PLACE(one_row_for_all, pixel.column)
PLACE(one_for_all, 0)

// Of a sphere, or of -1, the background.
static Color flat_color(const Scene *scene, int sphere)
{
    return sphere < 0 ? scene->background : scene_surface(scene, sphere)->color;
}

// Another color than this, the right one.
#define COLOR_OF(name, ...)                                                                        \
    static Color name(const Scene *scene, int sphere)                                              \
    {                                                                                              \
        Color color = flat_color(scene, sphere);                                                   \
        (void)color;                                                                               \
        return __VA_ARGS__;                                                                        \
    }

// ---- answers with slips -------------------------------------------------------------------------

typedef struct {
    double (*t_of)(Ray ray, Sphere sphere);
    bool (*replaces)(double t, double best);
    const Hit *start;                         // the best before the loops
    int first_sphere, last_sphere;            // how many are left out
    int most_spheres;                         // if not 0
    Ray (*ray_of)(Camera, Resolution, Pixel); // of that pixel
    Color (*color)(const Scene *scene, int sphere);
    bool (*left_out)(Pixel pixel, Resolution size);
    bool one_pass;                 // pixels that are left out do not get a background either
    bool no_background;            // it is never painted
    bool background_where_missed;  // by each sphere
    bool background_where_farther; // by each sphere, if it is not painted itself
    int (*place)(Pixel pixel, Resolution size); // in depth
    bool depth_kept;                            // not set before the loops
    bool depth_not_stored;
} Slips;

static const Hit nothing = {NO_HIT, -1};

static bool is_nearer(const Slips *slips, double t, double best)
{
    return (slips->replaces != NULL ? slips->replaces : nearer)(t, best);
}

static double t_of(const Slips *slips, Ray ray, Sphere sphere)
{
    return (slips->t_of != NULL ? slips->t_of : hit_sphere)(ray, sphere);
}

// The number of the sphere after the last one.
static int end_of(const Slips *slips, const Scene *scene)
{
    int count = scene->sphere_count - slips->last_sphere;
    return slips->most_spheres > 0 && slips->most_spheres < count ? slips->most_spheres : count;
}

static Hit nearest_with(Slips slips, Ray ray, const Scene *scene)
{
    Hit best = slips.start != NULL ? *slips.start : nothing;
    for (int i = slips.first_sphere; i < end_of(&slips, scene); i++) {
        double t = t_of(&slips, ray, scene->spheres[i]);
        if (is_nearer(&slips, t, best.t))
            best = (Hit){t, i};
    }
    return best;
}

static Pixel pixel_number(int i, Resolution size)
{
    return (Pixel){i % size.width, i / size.width};
}

static bool is_left_out(const Slips *slips, Pixel pixel, Resolution size)
{
    return slips->left_out != NULL && slips->left_out(pixel, size);
}

static Color color_of(const Slips *slips, const Scene *scene, int sphere)
{
    return (slips->color != NULL ? slips->color : flat_color)(scene, sphere);
}

static void cast_nothing(const Slips *slips, const Scene *scene, Image *image, double *depth)
{
    for (int i = 0; i < image->size.width * image->size.height; i++) {
        Pixel pixel = pixel_number(i, image->size);
        if (!slips->depth_kept)
            depth[i] = slips->start != NULL ? slips->start->t : NO_HIT;
        if (!slips->no_background && !(slips->one_pass && is_left_out(slips, pixel, image->size)))
            image_set(image, pixel, color_of(slips, scene, -1));
    }
}

static void cast_sphere(const Slips *slips, const Scene *scene, int sphere, Camera camera,
                        Image *image, double *depth)
{
    Resolution size = image->size;
    for (int i = 0; i < size.width * size.height; i++) {
        Pixel pixel = pixel_number(i, size);
        if (is_left_out(slips, pixel, size))
            continue;
        Ray ray = (slips->ray_of != NULL ? slips->ray_of : pixel_ray)(camera, size, pixel);
        double t = t_of(slips, ray, scene->spheres[sphere]);
        double *best = &depth[(slips->place != NULL ? slips->place : row_by_row)(pixel, size)];
        if (is_nearer(slips, t, *best)) {
            image_set(image, pixel, color_of(slips, scene, sphere));
            if (!slips->depth_not_stored)
                *best = t;
        } else if (slips->background_where_farther ||
                   (slips->background_where_missed && !(t < NO_HIT))) {
            image_set(image, pixel, scene->background);
        }
    }
}

static void cast_with(Slips slips, const Scene *scene, Camera camera, Image *image, double *depth)
{
    cast_nothing(&slips, scene, image, depth);
    for (int i = slips.first_sphere; i < end_of(&slips, scene); i++)
        cast_sphere(&slips, scene, i, camera, image, depth);
}

static double *depth_for(const Image *image)
{
    double *depth = calloc((size_t)image->size.width * (size_t)image->size.height, sizeof *depth);
    if (depth == NULL)
        abort();
    return depth;
}

#define LOOP(id, ...) LOOP_(id, __VA_ARGS__)
#define LOOP_(id, formula, why, picture, ...)                                                      \
    WRONG(nearest_hit, id, formula, why, picture)                                                  \
    {                                                                                              \
        return nearest_with((Slips){__VA_ARGS__}, ray, scene);                                     \
    }

#define IMAGE_ORDER(id, formula, why, picture, ...)                                                \
    WRONG(cast_image_order, id, formula, why, picture)                                             \
    {                                                                                              \
        double *depth = depth_for(image);                                                          \
        cast_with((Slips){.one_pass = true, __VA_ARGS__}, scene, camera, image, depth);            \
        free(depth);                                                                               \
    }

#define OBJECT_ORDER(id, formula, why, picture, ...)                                               \
    WRONG(cast_object_order, id, formula, why, picture)                                            \
    {                                                                                              \
        cast_with((Slips){__VA_ARGS__}, scene, camera, image, depth);                              \
    }

// The same slip in both orders.
#define BOTH_AS(image_id, object_id, ...)                                                          \
    IMAGE_ORDER(image_id, __VA_ARGS__)                                                             \
    OBJECT_ORDER(object_id, __VA_ARGS__)
#define BOTH(id, ...) BOTH_AS("I-" id, "O-" id, __VA_ARGS__)

// ---- nearest_hit: another sphere ----------------------------------------------------------------

LOOP("H1", "the last sphere of the list that is hit",
     "each hit replaces the one before, even a nearer one. The distance decides which sphere "
     "covers another, not the order of the scene.",
     "far spheres in front of near ones, in the order of the scene", .replaces = any_hit)
LOOP("H1-first", "the first sphere of the list that is hit",
     "the search stops too early: a sphere later in the list may be nearer.",
     "the first spheres of the scene cover everything", .replaces = hit_and_none_before)
LOOP("H3", "a best t that starts at -1",
     "hits are in front of the eye, t > 0, so none is ever below -1.", "blank: background only",
     .start = &(Hit){-1, -1})
LOOP("H3-0", "a best t that starts at 0",
     "hits are in front of the eye, t > 0, so none is ever below 0.", "blank: background only",
     .start = &(Hit){0, -1})
LOOP("H3-zeros", "all zeros: t = 0 on sphere 0",
     "this means that sphere 0 touches the eye, and nothing can be nearer than that.",
     "sphere 0's color everywhere", .start = &(Hit){0, 0})
LOOP("H3-10", "a best t that starts at 10",
     "some spheres are farther away than that, and if nothing is hit the result has t = NO_HIT.",
     "spheres cut off where they are far away", .start = &(Hit){10, -1})
LOOP("H3-1000", "a best t that starts at 1000",
     "a scene may be of any size, and if nothing is hit the result has t = NO_HIT.",
     "no visible difference, until a sphere is farther away than that", .start = &(Hit){1000, -1})
LOOP("H3-max", "t = DBL_MAX if nothing is hit",
     "a ray that misses everything never ends: its t is NO_HIT, which is infinite.",
     "no visible difference; but a caller who tests t < NO_HIT sees a hit",
     .start = &(Hit){DBL_MAX, -1})
LOOP("H-more", "no hit, whatever the ray",
     "does it compare with > a best t that starts at NO_HIT? NO_HIT is infinite, and no hit is "
     "farther away. Or does the loop never run?",
     "blank: background only", .replaces = more)
LOOP("H-miss", "the largest t, including NO_HIT",
     "the eye sees the nearest hit on a ray. And a missed sphere counts here as one that is "
     "infinitely far away.",
     "spheres at places where there are none", .start = &(Hit){0, -1}, .replaces = more)
LOOP("H-far", "the farthest hit",
     "the nearest sphere covers the farther ones; the smallest t wins.",
     "the scene from back to front: far spheres in front of near ones", .replaces = hit_and_farther)
LOOP("H-tie", "the last one of equally near spheres",
     "an equal t is not nearer. Of equal hits the lower index counts.",
     "another color where two spheres touch or coincide", .replaces = nearer_or_equal)
LOOP("H-from1", "sphere 0 left out", "spheres are counted from 0.",
     "the first sphere of the scene is missing", .first_sphere = 1)
LOOP("H-last", "the last sphere left out",
     "counted from 0, the last of n spheres has the index n - 1, and it must be tested.",
     "the last sphere of the scene is missing", .last_sphere = 1)
LOOP("R6-scene", "the t where the ray leaves the sphere",
     "the ray enters a sphere before it leaves it, and the eye sees the side that faces it.",
     "spheres seen from behind; a large one may vanish behind a small one", .t_of = far_root)
LOOP("R7-scene", "the smallest t, even if negative",
     "a ray starts at the eye. Hits with t < 0 are behind the eye.",
     "ghosts of the spheres behind the eye, mirrored and upside down", .t_of = near_root)
LOOP("R8-scene", "no hit on a sphere around the eye",
     "from inside, the near side is behind the eye, but the ray still leaves through the far one.",
     "a sphere vanishes as soon as the eye enters it", .t_of = near_root_in_front)
LOOP("D1-scene", "hits with t up to 1 dropped",
     "the image plane is a window, not a wall: spheres between it and the eye are visible.",
     "near spheres vanish", .t_of = hit_beyond_the_plane)
LOOP("R10-scene", "hits with t up to 0.1 dropped",
     "with a long direction even a small t may be a long way.", "near spheres vanish",
     .t_of = hit_beyond_a_tenth)
LOOP("R10-small", "hits with t up to 0.001 dropped",
     "with a long direction even a small t may be a long way.", "very near spheres vanish",
     .t_of = hit_beyond_a_thousandth)
LOOP("H-float", "t as a float",
     "a float has 7 digits and a double 16, as many as the t of hit_sphere.",
     "speckles where surfaces nearly touch", .t_of = hit_as_float)

// What a loop does with each t.
#define EACH_SPHERE(id, formula, why, picture, ...)                                                \
    WRONG(nearest_hit, id, formula, why, picture)                                                  \
    {                                                                                              \
        Hit best = nothing;                                                                        \
        double before = NO_HIT;                                                                    \
        for (int i = 0; i < scene->sphere_count; i++) {                                            \
            double t = hit_sphere(ray, scene->spheres[i]);                                         \
            bool found = best.sphere >= 0;                                                         \
            __VA_ARGS__;                                                                           \
            before = t;                                                                            \
            (void)before, (void)found;                                                             \
        }                                                                                          \
        return best;                                                                               \
    }

EACH_SPHERE("H-break", "the spheres up to the first miss",
            "a sphere that is missed says nothing about the next one: go on.",
            "spheres missing, depending on the order of the scene", if (t == NO_HIT) break;
            best = t < best.t ? (Hit){t, i} : best)
EACH_SPHERE("H-stop", "the spheres up to the first that is not nearer",
            "a sphere that is farther away says nothing about the next one: go on.",
            "far spheres in front of near ones, in the order of the scene",
            if (found && !(t < best.t)) break;
            best = t < best.t ? (Hit){t, i} : best)
EACH_SPHERE("H-reset", "the hits since the last miss",
            "a sphere that is missed does not change the other hits: keep the best so far.",
            "spheres missing, depending on the order of the scene",
            best = t == NO_HIT  ? nothing
                   : t < best.t ? (Hit){t, i}
                                : best)
EACH_SPHERE("H-before", "each sphere compared with the one before it",
            "compare with the nearest of all so far, and remember it.",
            "far spheres in front of near ones, in the order of the scene",
            best = t < before ? (Hit){t, i} : best)

WRONG(nearest_hit, "H-center", "the sphere whose center is nearest",
      "the eye sees surfaces. A large sphere may come nearer than a small one whose center is in "
      "front of its own.",
      "spheres that intersect are cut at the wrong place")
{
    Hit hit = nothing;
    double best = INFINITY;
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        double away = vec3_length(scene->spheres[i].center - ray.origin);
        if (t < NO_HIT && away < best) {
            best = away;
            hit = (Hit){t, i};
        }
    }
    return hit;
}

WRONG(nearest_hit, "H-abs", "the smallest |t|",
      "a ray starts at the eye. Hits with t < 0 are behind the eye, however near.",
      "ghosts of the spheres behind the eye, mirrored and upside down")
{
    Hit hit = nothing;
    for (int i = 0; i < scene->sphere_count; i++) {
        Roots roots = sphere_roots(ray, scene->spheres[i]);
        for (int k = 0; k < roots.count; k++)
            if (fabs(roots.t[k]) < fabs(hit.t))
                hit = (Hit){roots.t[k], i};
    }
    return hit;
}

WRONG(nearest_hit, "P7-scene", "the ray from the world's origin", "a ray starts at its origin.",
      "moving the camera changes nothing")
{
    ray.origin = vec3_of(0, 0, 0);
    return nearest_hit(ray, scene);
}

// ---- nearest_hit: the right sphere, but a wrong result ------------------------------------------

// From the right hit.
#define OF_NEAREST(id, formula, why, picture, ...)                                                 \
    WRONG(nearest_hit, id, formula, why, picture)                                                  \
    {                                                                                              \
        Hit hit = nearest_hit(ray, scene);                                                         \
        __VA_ARGS__;                                                                               \
    }

// The guard of the answering process comes after the last sphere.
OF_NEAREST(
    "H-count", "a loop up to i <= sphere_count",
    "n spheres have the numbers 0 to n - 1. There is no sphere number sphere_count: reading past "
    "the end of an array can give anything.",
    "a crash, or the color of a sphere that does not exist",
    double t = hit_sphere(ray, GUARD_SPHERE);
    return t < hit.t ? (Hit){t, scene->sphere_count} : hit)
OF_NEAREST("H-none0", "index 0 if nothing is hit", "0 is the first sphere; a miss is -1.",
           "the first sphere's color instead of the background",
           return hit.sphere < 0 ? (Hit){NO_HIT, 0} : hit)
OF_NEAREST("H-none-1", "t = -1 if nothing is hit",
           "-1 would be behind the eye, and nearer than every hit. NO_HIT is farther than all.",
           "no visible difference; but a caller who compares t takes a miss for the nearest hit",
           return hit.sphere < 0 ? (Hit){-1, -1} : hit)
OF_NEAREST("H-none-count", "sphere_count if nothing is hit",
           "the last sphere has the number sphere_count - 1, and a miss is -1.",
           "a crash, or an arbitrary color for the background",
           return hit.sphere < 0 ? (Hit){NO_HIT, scene->sphere_count} : hit)
OF_NEAREST("H-way", "the distance to the hit: t times the direction's length",
           "t counts in lengths of the direction, and a direction may have any length.",
           "the same picture; the point at that t is not on the sphere",
           return (Hit){hit.t * vec3_length(ray.direction), hit.sphere})
OF_NEAREST("H-surface", "the index of the sphere's surface",
           "several spheres may share a surface, so it does not tell which of them was hit.",
           "spheres in each other's colors",
           return (Hit){hit.t, hit.sphere < 0 ? -1 : scene->spheres[hit.sphere].surface})
OF_NEAREST("H-count1", "the spheres counted from 1", "the first sphere has the index 0.",
           "each sphere in the next one's color",
           return (Hit){hit.t, hit.sphere < 0 ? -1 : hit.sphere + 1})
OF_NEAREST("H-no-sphere", "the right t, with -1 for the sphere",
           "-1 says that nothing was hit. Return the index of the sphere with this t.",
           "blank: background only", return (Hit){hit.t, -1})
// As without the braces of an if: the statements for a hit are executed for every sphere.
OF_NEAREST("H-braces", "the right t, but the last sphere",
           "the index changes with every sphere, whether it is nearer or not. An if without braces "
           "ends after one statement.",
           "everything in the last sphere's color", return (Hit){hit.t, scene->sphere_count - 1})
OF_NEAREST("H-first-index", "the right t, but the first hit's index",
           "a nearer hit replaces both: the t and the index of its sphere.",
           "spheres in each other's colors",
           hit.sphere = nearest_with((Slips){.replaces = hit_and_none_before}, ray, scene).sphere;
           return hit)
WRONG_LINE(nearest_hit, "H-no-t", "the last sphere that is hit, with t = NO_HIT",
           "comparing works only if you remember the best t so far together with its sphere.",
           "far spheres in front of near ones, in the order of the scene",
           Hit hit = nearest_with((Slips){.replaces = any_hit}, ray, scene);
           return (Hit){NO_HIT, hit.sphere})

// ---- limits that no scene has -------------------------------------------------------------------

// The formula, why, and the picture.
#define BEYOND_WORDS(least)                                                                        \
    "hits with t up to " least " dropped",                                                         \
        "t counts in lengths of the direction, and scenes are of any size: every hit with t > 0 "  \
        "is in front of the eye.",                                                                 \
        "right in scenes of one size, holes in others"
#define BELOW_WORDS(most)                                                                          \
    "only hits with t below " most, "a scene may be of any size: every t > 0 is a hit.",           \
        "no visible difference, until a sphere is farther away than that"
#define NEARER_WORDS(epsilon)                                                                      \
    "only hits that are nearer by " epsilon,                                                       \
        "scenes are of any size, and t counts in lengths of the direction: nearer is nearer, by "  \
        "however little.",                                                                         \
        "right in scenes of one size, wrong colors in smaller ones"
#define FLOAT_WORDS                                                                                \
    "t compared as floats",                                                                        \
        "a float has 7 digits, a double 16, and spheres may be close together.",                   \
        "speckles where surfaces nearly touch"
#define ROOM_WORDS(number)                                                                         \
    "the first " number " spheres", "the number of spheres in the scene is sphere_count.",         \
        "no visible difference, until a scene has more spheres"

#define BEYOND(name, least)                                                                        \
    T_BEYOND(name, least)                                                                          \
    LOOP("H-" #least, BEYOND_WORDS(#least), .t_of = name)                                          \
    BOTH("t-" #least, BEYOND_WORDS(#least), .t_of = name)
#define LOOP_BELOW(name, most)                                                                     \
    T_BELOW(name, most)                                                                            \
    LOOP("H-up-" #most, BELOW_WORDS(#most), .t_of = name)
#define BELOW(name, most)                                                                          \
    LOOP_BELOW(name, most)                                                                         \
    BOTH("up-" #most, BELOW_WORDS(#most), .t_of = name)
#define NEARER_BY(name, epsilon) REPLACES(name, t < best - (epsilon))
#define LOOP_NEARER_BY(name, epsilon)                                                              \
    NEARER_BY(name, epsilon)                                                                       \
    LOOP("H-by-" #epsilon, NEARER_WORDS(#epsilon), .replaces = name)
#define ALL_NEARER_BY(name, epsilon)                                                               \
    LOOP_NEARER_BY(name, epsilon)                                                                  \
    BOTH("by-" #epsilon, NEARER_WORDS(#epsilon), .replaces = name)
#define ROOM(number)                                                                               \
    LOOP("H-room" #number, ROOM_WORDS(#number), .most_spheres = number)                            \
    BOTH("room" #number, ROOM_WORDS(#number), .most_spheres = number)

BOTH("t-0.001", BEYOND_WORDS("0.001"), .t_of = hit_beyond_a_thousandth)
BEYOND(hit_beyond_1e_4, 1e-4)
BEYOND(hit_beyond_1e_5, 1e-5)
BEYOND(hit_beyond_1e_6, 1e-6)
BEYOND(hit_beyond_1e_9, 1e-9)
LOOP_BELOW(hit_below_100, 100)
BELOW(hit_below_1000, 1000)
LOOP_BELOW(hit_below_10000, 10000)
LOOP_BELOW(hit_below_1e5, 1e5)
BELOW(hit_below_1e6, 1e6)
BELOW(hit_below_1e9, 1e9)
LOOP_BELOW(hit_below_1e10, 1e10)
BELOW(hit_below_1e12, 1e12)
NEARER_BY(nearer_by_a_thousandth, 1e-3)
LOOP("H-by-1e-3", NEARER_WORDS("0.001"), .replaces = nearer_by_a_thousandth)
BOTH("by-0.001", NEARER_WORDS("0.001"), .replaces = nearer_by_a_thousandth)
LOOP_NEARER_BY(nearer_by_a_hundred_thousandth, 1e-5)
ALL_NEARER_BY(nearer_by_a_millionth, 1e-6)
ALL_NEARER_BY(nearer_by_a_billionth, 1e-9)
LOOP("H-by-float", FLOAT_WORDS, .replaces = nearer_as_floats)
BOTH("by-float", FLOAT_WORDS, .replaces = nearer_as_floats)
ROOM(10)
ROOM(16)
ROOM(32)
ROOM(64)
ROOM(100)
ROOM(128)
ROOM(256)

// ---- both orders: rays, spheres and pixels ------------------------------------------------------

BOTH_AS("I-flip", "O-flip", "the rows counted from the bottom",
        "row 0 of the image is the top one, and pixel_ray counts in the same way.", "upside down",
        .ray_of = row_from_below)
BOTH_AS("I-mirror", "O-mirror", "the columns counted from the right",
        "column 0 is the left one, and pixel_ray counts in the same way.", "mirrored",
        .ray_of = column_from_the_right)
BOTH_AS("P4", "P4-object", "row and column swapped",
        "a pixel is (column, row): how far to the right, then how far down; here it gets the "
        "ray of (row, column).",
        "right and down swapped", .ray_of = row_and_column_swapped)
BOTH_AS("P7", "P7-object", "rays from the world's origin", "rays start at the eye.",
        "moving the camera changes nothing", .ray_of = from_the_worlds_origin)
BOTH("N3", "divided by width - 1 and height - 1",
     "W pixels are W steps wide, and the ray goes through the center of its pixel: use pixel_ray.",
     "slightly too large; nothing in an image of one row or one column",
     .ray_of = through_width_less_1)
BOTH("height-shape", "the height of the image plane from the image's shape",
     "the camera gives the height of its plane. pixel_ray uses it unchanged.",
     "stretched if pixels are not square", .ray_of = height_of_the_shape)
BOTH("width-shape", "the width of the image plane from the image's shape",
     "the camera gives the width of its plane. pixel_ray uses it unchanged.",
     "stretched if pixels are not square", .ray_of = width_of_the_shape)
BOTH("plane1", "an image plane 1 away",
     "the camera gives the distance of its plane. pixel_ray uses it unchanged.",
     "spheres too small or too large, unless the distance is 1", .ray_of = plane_1_away)
BOTH_AS("D1-image", "D1-object", "hits with t up to 1 dropped",
        "the image plane is a window, not a wall: spheres between it and the eye are visible.",
        "near spheres vanish", .t_of = hit_beyond_the_plane)
BOTH_AS("R7-image", "R7-object", "the smallest t, even below 0",
        "a ray starts at the eye. Hits with t < 0 are behind the eye.",
        "ghosts of the spheres behind the eye, mirrored and upside down", .t_of = near_root)
BOTH_AS("R8-image", "R8-object", "no hit on a sphere around the eye",
        "the ray still leaves such a sphere through its far side.",
        "a sphere vanishes as soon as the eye enters it", .t_of = near_root_in_front)
BOTH_AS("I-far", "Z-far", "the farthest hit", "the nearest sphere covers the farther ones.",
        "the scene from back to front", .replaces = hit_and_farther)
BOTH("rest", "only hits painted",
     "if nothing is hit, the old color of the image stays. Every pixel needs a color.",
     "spheres on the old contents of the image, at first black", .no_background = true)

// ---- image order --------------------------------------------------------------------------------

IMAGE_ORDER("I-turn", "the pixels from the last to the first",
            "the ray of the lower right pixel colors the upper left one.", "turned by 180 degrees",
            .ray_of = turned)
IMAGE_ORDER("I-from1", "the pixels counted from 1",
            "the first column and the first row are number 0; so each pixel shows its neighbour.",
            "shifted by a pixel, to the left and up", .ray_of = next_one)
IMAGE_ORDER("I-one", "the ray of the first pixel for all", "every pixel has its own ray.",
            "all in one color", .ray_of = always_the_first)
IMAGE_ORDER("I-size", "width and height swapped",
            "a resolution is the number of columns, then the number of rows.",
            "spheres stretched, part of the scene cut off; right in a square image",
            .ray_of = width_and_height_swapped)
IMAGE_ORDER("P1", "rays through the pixels' corners",
            "a pixel is a small square, and its ray goes through the center: half a pixel to the "
            "right and half a pixel down.",
            "everything moved by half a pixel, to the right and down", .ray_of = through_corner)
IMAGE_ORDER("P2", "rays through the lower right corners",
            "from its upper left corner to its center it is half a pixel each way, once.",
            "everything moved by half a pixel, to the left and up", .ray_of = through_lower_right)
IMAGE_ORDER("I-column0", "column 0 not painted", "columns are counted from 0.",
            "a stripe at the left edge", .left_out = in_first_column)
IMAGE_ORDER("I-row0", "row 0 not painted", "rows are counted from 0.", "a stripe at the upper edge",
            .left_out = in_first_row)
IMAGE_ORDER("I-column", "the last column not painted",
            "counted from 0, the last of W columns is number W - 1, and it must be painted.",
            "a stripe at the right edge", .left_out = in_last_column)
IMAGE_ORDER("I-row", "the last row not painted",
            "counted from 0, the last of H rows is number H - 1, and it must be painted.",
            "a stripe at the lower edge", .left_out = in_last_row)
IMAGE_ORDER("I-last", "the last hit of the list",
            "the distance decides which sphere covers another, not the order of the scene.",
            "far spheres in front of near ones, in the order of the scene", .replaces = any_hit)
IMAGE_ORDER("I-first", "the first hit of the list", "a sphere later in the list may be nearer.",
            "the first spheres of the scene cover everything", .replaces = hit_and_none_before)
IMAGE_ORDER("I-only", "sphere 0 alone",
            "each ray must be tested against every sphere of the scene.", "one sphere only",
            .most_spheres = 1)
IMAGE_ORDER("I-tie", "the last of equally near spheres", "of equal hits the lower index counts.",
            "another color where two spheres touch or coincide", .replaces = nearer_or_equal)
IMAGE_ORDER("R6-image", "spheres compared by where rays leave them",
            "the eye sees the point where the ray enters. A large sphere may start in front of a "
            "small one and end behind it.",
            "small spheres seen through large ones", .t_of = far_root)

COLOR_OF(always_background, scene->background)
IMAGE_ORDER("I-none", "the background everywhere",
            "no hit ever colors its pixel. How do you distinguish a hit from a miss?", "blank",
            .color = always_background)
COLOR_OF(sphere_0_is_nothing, sphere > 0 ? color : scene->background)
IMAGE_ORDER("I-0", "index 0 treated as a miss", "0 is the first sphere; a miss is -1.",
            "a hole in the shape of the first sphere", .color = sphere_0_is_nothing)

WRONG(cast_image_order, "I-break", "a row given up at its first miss",
      "a ray that hits nothing says nothing about the next one. Its own pixel needs a color as "
      "well.",
      "black; only spheres that touch the left edge are seen")
{
    for (int row = 0; row < image->size.height; row++)
        for (int column = 0; column < image->size.width; column++) {
            Pixel pixel = {column, row};
            Hit hit = nearest_hit(pixel_ray(camera, image->size, pixel), scene);
            if (hit.sphere < 0)
                break;
            image_set(image, pixel, flat_color(scene, hit.sphere));
        }
}

// The color of a hit is kept for the next pixels of the row and below.
WRONG(cast_image_order, "I-kept", "the color of the last hit if nothing is hit",
      "if nothing is hit, the pixel has the background's color: set it for each pixel.",
      "spheres smeared to the right and down")
{
    int sphere = -1;
    for (int i = 0; i < image->size.width * image->size.height; i++) {
        Pixel pixel = pixel_number(i, image->size);
        Hit hit = nearest_hit(pixel_ray(camera, image->size, pixel), scene);
        sphere = hit.sphere >= 0 ? hit.sphere : sphere;
        image_set(image, pixel, flat_color(scene, sphere));
    }
}

WRONG(cast_image_order, "I-pixel", "the last pixel not painted",
      "the W * H pixels have the numbers 0 to W * H - 1, and the last one must be painted.",
      "a dot in the lower right corner")
{
    Resolution size = image->size;
    Pixel last = {size.width - 1, size.height - 1};
    uint8_t *bytes = image_bytes(image, last), kept[3] = {bytes[0], bytes[1], bytes[2]};
    cast_image_order(scene, camera, image);
    for (int i = 0; i < 3; i++)
        bytes[i] = kept[i];
}

// ---- both orders: the colors -------------------------------------------------------------------

#define COLORS(name, id, formula, why, picture, ...)                                               \
    COLOR_OF(name, __VA_ARGS__)                                                                    \
    BOTH(id, formula, why, picture, .color = name)

COLORS(black_background, "black", "black if nothing is hit",
       "the scene has its own background color.", "spheres on black",
       sphere < 0 ? vec3_of(0, 0, 0) : color)
COLORS(surface_of_that_number, "index", "the surface of the sphere's number",
       "spheres and surfaces are numbered separately; each sphere has the number of its surface.",
       "spheres in each other's colors",
       sphere < 0 ? color : scene->surfaces[sphere % scene->surface_count].color)
COLORS(first_surface, "white", "always surface 0", "each sphere has the number of its surface.",
       "all spheres in one color", sphere < 0 ? color : scene->surfaces[0].color)
COLORS(blue_green_red, "bgr", "blue, green, red", "the first of the three numbers is red.",
       "red and blue swapped", vec3_of(color[2], color[1], color[0]))
COLORS(times_255, "255", "colors times 255",
       "colors go from 0 to 1; the image converts them to bytes.",
       "everything that is not black is too bright", 255 * color)
COLORS(through_255, "1/255", "colors divided by 255",
       "colors already go from 0 to 1; the image converts them to bytes.", "nearly black",
       color / 255)
COLORS(surface_times_255, "255-surface", "the surface's color times 255",
       "colors go from 0 to 1, also those of surfaces; the image converts them to bytes.",
       "spheres too bright on the right background", sphere < 0 ? color : 255 * color)
COLORS(surface_through_255, "1/255-surface", "the surface's color divided by 255",
       "colors already go from 0 to 1, also those of surfaces; the image converts them to bytes.",
       "nearly black spheres on the right background", sphere < 0 ? color : color / 255)
COLORS(ambient_background, "ambient", "the ambient light if nothing is hit",
       "the scene has both, and they differ: use its background.", "spheres on another background",
       sphere < 0 ? scene->ambient : color)
COLORS(white_background, "white-sky", "white if nothing is hit",
       "the scene has its own background color.", "spheres on white",
       sphere < 0 ? vec3_of(1, 1, 1) : color)
COLORS(background_of_surface_0, "sky-surface", "the color of surface 0 if nothing is hit",
       "only spheres have surfaces; the scene has its own background color.",
       "spheres on another background", sphere < 0 ? scene->surfaces[0].color : color)
COLORS(in_whole_numbers, "int", "colors without the digits after the decimal point",
       "colors are numbers from 0 to 1, mostly in between: keep them in a Color or in doubles.",
       "black, except where a color is 1",
       vec3_of(trunc(color[0]), trunc(color[1]), trunc(color[2])))
COLORS(all_white, "all-white", "white everywhere",
       "the scene has the colors of its background and of each surface.", "white", vec3_of(1, 1, 1))
COLORS(all_black, "all-black", "black everywhere",
       "the scene has the colors of its background and of each surface.", "black", vec3_of(0, 0, 0))
COLORS(times_kd, "kd", "kd times the surface's color",
       "kd is used in chapter 07: here colors are flat.", "spheres too dark",
       sphere < 0 ? color : scene_surface(scene, sphere)->diffuse * color)
COLORS(encoded, "gamma", "colors to the power of 1 / 2.2",
       "the image takes colors unchanged: no gamma here.", "everything too pale",
       vec3_of(pow(color[0], 1 / 2.2), pow(color[1], 1 / 2.2), pow(color[2], 1 / 2.2)))
COLORS(green_red_blue, "grb", "green, red, blue", "the first of the three numbers is red.",
       "red and green swapped", vec3_of(color[1], color[0], color[2]))
COLORS(grey_of_it, "grey", "the mean of red, green and blue",
       "each of the three has its own byte in the image.", "a grey picture",
       vec3_of(1, 1, 1) * ((color[0] + color[1] + color[2]) / 3))

// ---- object order: spheres and pixels -----------------------------------------------------------

OBJECT_ORDER(
    "R6-object", "the t where the ray leaves the sphere",
    "the ray enters a sphere before it leaves it, and the eye sees the side that faces it.",
    "small spheres seen through large ones", .t_of = far_root)
OBJECT_ORDER("O-wipe", "each sphere erases the pixels where it is missed",
             "another sphere may already be visible there. A miss says nothing about the others.",
             "only the last sphere", .background_where_missed = true)
OBJECT_ORDER("O-else", "each sphere erases the pixels where it is not the nearest so far",
             "the colors of other spheres must stay. Paint the background once, before all "
             "spheres.",
             "the last sphere, with holes where others are in front of it",
             .background_where_farther = true)
OBJECT_ORDER("O-from1", "sphere 0 left out", "spheres are counted from 0.",
             "the first sphere of the scene is missing", .first_sphere = 1)
OBJECT_ORDER("O-last", "the last sphere left out",
             "counted from 0, the last of n spheres has the index n - 1, and it must be tested.",
             "the last sphere of the scene is missing", .last_sphere = 1)
OBJECT_ORDER("O-only", "sphere 0 alone", "every sphere of the scene must be tested.",
             "one sphere only", .most_spheres = 1)
OBJECT_ORDER("O-row", "no sphere in the last row",
             "counted from 0, the last of H rows is number H - 1, and it must be painted.",
             "a stripe of background at the lower edge", .left_out = in_last_row)
OBJECT_ORDER("O-column", "no sphere in the last column",
             "counted from 0, the last of W columns is number W - 1, and it must be painted.",
             "a stripe of background at the right edge", .left_out = in_last_column)

// ---- object order: the depths -------------------------------------------------------------------

#define STARTS(id, formula, why, picture, t)                                                       \
    OBJECT_ORDER(id, formula, why, picture, .start = &(Hit){t, -1})
#define STARTS_AT(t)                                                                               \
    STARTS("Z-" #t, "depths that start at " #t,                                                    \
           "a scene may be of any size. If nothing is hit the depth is NO_HIT.",                   \
           "no visible difference, until a sphere is farther away than that", t)

OBJECT_ORDER("Z-kept", "depths that are never initialised",
             "the values in depth before the call are arbitrary. Before the first sphere nothing "
             "has been hit: set every depth to NO_HIT.",
             "holes, or nothing at all, and at other times no visible difference",
             .depth_kept = true)
STARTS("Z-minus", "depths that start at -1",
       "hits are in front of the eye, t > 0, so none is ever below -1.", "blank", -1)
STARTS("Z-0", "depths that start at 0",
       "hits are in front of the eye, t > 0, so none is ever below 0.", "blank", 0)
STARTS_AT(100)
STARTS_AT(1000)
STARTS_AT(1e6)
STARTS_AT(1e9)
STARTS_AT(1e30)
STARTS("Z-max", "DBL_MAX if nothing is hit",
       "a ray that misses everything never ends: its t is NO_HIT, which is infinite.",
       "the same picture; but a caller who tests t < NO_HIT sees a hit", DBL_MAX)
OBJECT_ORDER(
    "Z-never", "depths that are never changed",
    "each sphere is compared with NO_HIT. A pixel must remember the t of its nearest hit so far.",
    "far spheres in front of near ones, in the order of the scene", .depth_not_stored = true)
OBJECT_ORDER("H1-object", "each sphere painted wherever it is hit",
             "was something nearer hit in that pixel before? The depth answers that.",
             "far spheres in front of near ones, in the order of the scene", .replaces = any_hit)
OBJECT_ORDER("Z-first", "pixels painted only once",
             "a sphere later in the list may be nearer, and covers the color that is there.",
             "the first spheres of the scene cover everything", .replaces = hit_and_none_before)
OBJECT_ORDER("Z-tie", "painted over at equal depths",
             "an equal t is not nearer. Of equal hits the lower index counts.",
             "another color where two spheres touch or coincide", .replaces = nearer_or_equal)
OBJECT_ORDER(
    "Z-more", "hits with t above the depth",
    "at first the depth is NO_HIT, and no hit is farther away than that. The nearest hit counts.",
    "blank", .replaces = hit_and_more)
OBJECT_ORDER("Z-turned", "depths column by column",
             "they go row by row from the top, in reading order.",
             "no visible difference; but a caller who reads the depths finds them transposed",
             .place = column_by_column)
OBJECT_ORDER("Z-bottom", "depths from the bottom row up",
             "they go row by row from the top, as the image does.",
             "no visible difference; but a caller who reads the depths finds them upside down",
             .place = from_the_bottom)
OBJECT_ORDER("Z-float", "t as a float",
             "a float has 7 digits and a double 16, as many as the t of hit_sphere.",
             "speckles where surfaces nearly touch", .t_of = hit_as_float)
OBJECT_ORDER(
    "Z-row", "one row of depths for all rows",
    "every pixel has its own depth: with only one row, a sphere hides those above and below it.",
    "parts of spheres missing", .place = one_row_for_all)
OBJECT_ORDER("Z-one", "one depth for all pixels",
             "every pixel has its own depth: with only one, a sphere hides those beside it.",
             "single pixels of a sphere, here and there", .place = one_for_all)

// After the right answer, something in each pixel and its depth.
#define EACH_PIXEL(id, formula, why, picture, ...)                                                 \
    WRONG(cast_object_order, id, formula, why, picture)                                            \
    {                                                                                              \
        Resolution size = image->size;                                                             \
        cast_object_order(scene, camera, image, depth);                                            \
        for (int i = 0; i < size.width * size.height; i++) {                                       \
            __VA_ARGS__;                                                                           \
        }                                                                                          \
    }

// As without the braces of an if: the statements for nearer hits are executed for every pixel.
EACH_PIXEL("O-braces", "every sphere paints every pixel",
           "the depths are right, but the color changes whether the sphere is nearer or not. An "
           "if without braces ends after one statement.",
           "everything in the last sphere's color",
           image_set(image, pixel_number(i, size), flat_color(scene, scene->sphere_count - 1)))
EACH_PIXEL("Z-way", "the distance to the hit",
           "the depth is t, which counts in lengths of the ray's direction; and these differ from "
           "pixel to pixel.",
           "the same picture",
           depth[i] *= vec3_length(pixel_ray(camera, size, pixel_number(i, size)).direction))
EACH_PIXEL("Z-none0", "a depth of 0 if nothing is hit",
           "0 is at the eye, nearer than all hits. A miss is infinitely far away: NO_HIT.",
           "the same picture", depth[i] = depth[i] < NO_HIT ? depth[i] : 0)
EACH_PIXEL("Z-none-1", "-1 if nothing is hit",
           "-1 is behind the eye. A miss is infinitely far away: NO_HIT.", "the same picture",
           depth[i] = depth[i] < NO_HIT ? depth[i] : -1)

// In an image that is higher than wide this index goes past the last depth, so there is room for
// it.
static void rows_of_the_height(bool all_set_first, const Scene *scene, Camera camera, Image *image,
                               double *depth)
{
    Resolution size = image->size;
    int pixels = size.width * size.height;
    Image square = {.size = {size.width + size.height, size.width + size.height}};
    double *own = depth_for(&square);
    memcpy(own, depth, (size_t)pixels * sizeof *own);
    for (int i = 0; i < pixels; i++) {
        Pixel pixel = pixel_number(i, size);
        own[all_set_first ? i : times_the_height(pixel, size)] = NO_HIT;
        image_set(image, pixel, scene->background);
    }
    const Slips slips = {.place = times_the_height};
    for (int i = 0; i < scene->sphere_count; i++)
        cast_sphere(&slips, scene, i, camera, image, own);
    memcpy(depth, own, (size_t)pixels * sizeof *own);
    free(own);
}

WRONG_LINE(cast_object_order, "Z-height", "depth[row * height + column]",
           "a row is as long as the image is wide: row * width pixels come before it.",
           "right in a square image; in others parts of spheres are missing",
           rows_of_the_height(true, scene, camera, image, depth))
WRONG_LINE(cast_object_order, "Z-height-set",
           "depth[row * height + column], also in the loop that initialises it",
           "a row is as long as the image is wide: row * width pixels come before it.",
           "right in a square image; in others parts of spheres are missing",
           rows_of_the_height(false, scene, camera, image, depth))

WRONG(
    cast_object_order, "Z-each", "depths reset for each sphere",
    "each sphere forgets the ones before it, and is painted over them even if it is farther away.",
    "far spheres in front of near ones, in the order of the scene")
{
    const Slips slips = {0};
    cast_nothing(&slips, scene, image, depth);
    for (int i = 0; i < scene->sphere_count; i++) {
        cast_nothing(&(Slips){.no_background = true}, scene, image, depth);
        cast_sphere(&slips, scene, i, camera, image, depth);
    }
}

// A pixel that has a depth already keeps it, whatever is painted there.
WRONG(cast_object_order, "Z-first-t", "the depth of the first hit kept",
      "when a nearer sphere is painted, store its t as well.",
      "far spheres in front of near ones, in the order of the scene")
{
    cast_nothing(&(Slips){0}, scene, image, depth);
    for (int sphere = 0; sphere < scene->sphere_count; sphere++)
        for (int i = 0; i < image->size.width * image->size.height; i++) {
            Pixel pixel = pixel_number(i, image->size);
            double t = hit_sphere(pixel_ray(camera, image->size, pixel), scene->spheres[sphere]);
            if (!(t < depth[i]))
                continue;
            image_set(image, pixel, flat_color(scene, sphere));
            depth[i] = depth[i] == NO_HIT ? t : depth[i];
        }
}

WRONG(cast_object_order, "Z-own", "depths in an array of your own",
      "the picture is right, but the caller also needs the depths, in the array depth.",
      "the same picture")
{
    double *own = depth_for(image);
    cast_object_order(scene, camera, image, own);
    free(own);
}
