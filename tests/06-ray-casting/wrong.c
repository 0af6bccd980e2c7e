// wrong.c - wrong answers to exercise 06.
#include "exercises/01-corners.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"

#include "tests/judge/known.h"
#include "tests/judge/wire.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

// ---- where a sphere is hit ----------------------------------------------------------------------

static double near_root(Ray ray, Sphere sphere)
{
    Roots roots = sphere_roots(ray, sphere);
    return roots.count > 0 ? roots.t[0] : NO_HIT;
}

static double near_root_in_front(Ray ray, Sphere sphere)
{
    double t = near_root(ray, sphere);
    return t > 0 ? t : NO_HIT;
}

static double far_root(Ray ray, Sphere sphere)
{
    Roots roots = sphere_roots(ray, sphere);
    return roots.count > 0 && roots.t[1] > 0 ? roots.t[1] : NO_HIT;
}

static double hit_beyond(double least, Ray ray, Sphere sphere)
{
    double t = hit_sphere(ray, sphere);
    return t > least ? t : NO_HIT;
}

static double hit_beyond_the_plane(Ray ray, Sphere sphere)
{
    return hit_beyond(1, ray, sphere);
}

static double hit_as_float(Ray ray, Sphere sphere)
{
    return (float)hit_sphere(ray, sphere);
}

// ---- which hit replaces the best so far ---------------------------------------------------------

static bool nearer(double t, double best)
{
    return t < best;
}

static bool nearer_or_equal(double t, double best)
{
    return t < NO_HIT && t <= best;
}

static bool any_hit(double t, double best)
{
    (void)best;
    return t < NO_HIT;
}

static bool hit_and_none_before(double t, double best)
{
    return t < NO_HIT && best == NO_HIT;
}

static bool hit_and_farther(double t, double best)
{
    return t < NO_HIT && (best == NO_HIT || t > best);
}

// ---- whose ray, and what colour -----------------------------------------------------------------

static Pixel row_from_below(Pixel pixel, Resolution size)
{
    return (Pixel){pixel.column, size.height - 1 - pixel.row};
}

static Pixel column_from_the_right(Pixel pixel, Resolution size)
{
    return (Pixel){size.width - 1 - pixel.column, pixel.row};
}

static Pixel row_and_column_swapped(Pixel pixel, Resolution size)
{
    (void)size;
    return (Pixel){pixel.row, pixel.column};
}

static bool in_last_column(Pixel pixel, Resolution size)
{
    return pixel.column == size.width - 1;
}

static bool in_last_row(Pixel pixel, Resolution size)
{
    return pixel.row == size.height - 1;
}

// Of a sphere, or of -1, the background.
static Color flat_color(const Scene *scene, int sphere)
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

static Pixel pixel_number(int i, Resolution size)
{
    return (Pixel){i % size.width, i / size.width};
}

static int row_by_row(Pixel pixel, Resolution size)
{
    return pixel.row * size.width + pixel.column;
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
            depth[i] = slips->depth_starts_elsewhere ? slips->depth_start : NO_HIT;
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

static void cast_with(Slips slips, const Scene *scene, Camera camera, Image *image, double *depth)
{
    cast_nothing(&slips, scene, image, depth);
    for (int i = slips.first_sphere; i < scene->sphere_count - slips.last_sphere; i++)
        cast_sphere(&slips, scene, i, camera, image, depth);
}

#define OBJECT_ORDER(id, formula, why, picture, ...)                                               \
    WRONG(cast_object_order, id, formula, why, picture)                                            \
    {                                                                                              \
        cast_with((Slips){__VA_ARGS__}, scene, camera, image, depth);                              \
    }

static double *depth_for(const Image *image)
{
    double *depth = calloc((size_t)image->size.width * (size_t)image->size.height, sizeof *depth);
    if (depth == NULL)
        abort();
    return depth;
}

#define IMAGE_ORDER(id, formula, why, picture, ...)                                                \
    WRONG(cast_image_order, id, formula, why, picture)                                             \
    {                                                                                              \
        double *depth = depth_for(image);                                                          \
        cast_with((Slips){.one_pass = true, __VA_ARGS__}, scene, camera, image, depth);            \
        free(depth);                                                                               \
    }

// ---- t, from or up to a limit -------------------------------------------------------------------

#define HIT_BEYOND(name, least)                                                                    \
    static inline double name(Ray ray, Sphere sphere)                                              \
    {                                                                                              \
        return hit_beyond(least, ray, sphere);                                                     \
    }

HIT_BEYOND(hit_beyond_a_tenth, 0.1)
HIT_BEYOND(hit_beyond_a_thousandth, 1e-3)
HIT_BEYOND(hit_beyond_1e_4, 1e-4)
HIT_BEYOND(hit_beyond_1e_5, 1e-5)
HIT_BEYOND(hit_beyond_1e_6, 1e-6)
HIT_BEYOND(hit_beyond_1e_9, 1e-9)

#define HIT_BEFORE(name, most)                                                                     \
    static inline double name(Ray ray, Sphere sphere)                                              \
    {                                                                                              \
        double t = hit_sphere(ray, sphere);                                                        \
        return t < (most) ? t : NO_HIT;                                                            \
    }

HIT_BEFORE(hit_before_100, 100)
HIT_BEFORE(hit_before_1000, 1e3)
HIT_BEFORE(hit_before_10000, 1e4)
HIT_BEFORE(hit_before_1e5, 1e5)
HIT_BEFORE(hit_before_1e6, 1e6)
HIT_BEFORE(hit_before_1e9, 1e9)
HIT_BEFORE(hit_before_1e10, 1e10)
HIT_BEFORE(hit_before_1e12, 1e12)

// ---- nearer by more than a limit ----------------------------------------------------------------

static bool nearer_as_floats(double t, double best)
{
    return (float)t < (float)best;
}

#define NEARER_BY(name, epsilon)                                                                   \
    static inline bool name(double t, double best)                                                 \
    {                                                                                              \
        return t < best - (epsilon);                                                               \
    }

NEARER_BY(nearer_by_a_thousandth, 1e-3)
NEARER_BY(nearer_by_a_hundred_thousandth, 1e-5)
NEARER_BY(nearer_by_a_millionth, 1e-6)
NEARER_BY(nearer_by_a_billionth, 1e-9)

// A scene of this many spheres, if it has more.
static Scene at_most(int most, const Scene *scene)
{
    Scene some = *scene;
    some.sphere_count = scene->sphere_count < most ? scene->sphere_count : most;
    return some;
}

// ---- the nearest, in one loop -------------------------------------------------------------------

static const Hit nothing = {NO_HIT, -1};

static Hit best_of(Hit best, double (*t_of)(Ray ray, Sphere sphere),
                   bool (*replaces)(double t, double best), Ray ray, const Scene *scene)
{
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = t_of(ray, scene->spheres[i]);
        if (replaces(t, best.t))
            best = (Hit){t, i};
    }
    return best;
}

#define LOOP(id, formula, why, picture, best, t_of, replaces)                                      \
    WRONG(nearest_hit, id, formula, why, picture)                                                  \
    {                                                                                              \
        return best_of(best, t_of, replaces, ray, scene);                                          \
    }

// ---- one loop, and possible slips in it ---------------------------------------------------------

static bool more(double t, double best)
{
    return t > best;
}

static Hit last_hit(Ray ray, const Scene *scene)
{
    return best_of(nothing, hit_sphere, any_hit, ray, scene);
}

static Hit first_hit(Ray ray, const Scene *scene)
{
    return best_of(nothing, hit_sphere, hit_and_none_before, ray, scene);
}

// ---- the right sphere, but a wrong result ------------------------------------------------------

WRONG_BY(last_hit, nearest_hit, "H1", "the last sphere of the list that is hit",
         "each hit replaces the one before, even a nearer one. The distance decides which sphere "
         "covers another, not the order of the scene.",
         "far spheres in front of near ones, in the order of the scene")
WRONG_BY(first_hit, nearest_hit, "H1-first", "the first sphere of the list that is hit",
         "the search stops too early: a sphere later in the list may be nearer.",
         "the first spheres of the scene cover everything")
LOOP("H3", "a best t that starts at -1",
     "hits are in front of the eye, t > 0, so none is ever below -1.", "blank: background only",
     ((Hit){-1, -1}), hit_sphere, nearer)
LOOP("H3-0", "a best t that starts at 0",
     "hits are in front of the eye, t > 0, so none is ever below 0.", "blank: background only",
     ((Hit){0, -1}), hit_sphere, nearer)
LOOP("H3-zeros", "all zeros: t = 0 on sphere 0",
     "this means that sphere 0 touches the eye, and nothing can be nearer than that.",
     "sphere 0's colour everywhere", ((Hit){0, 0}), hit_sphere, nearer)
LOOP("H3-10", "a best t that starts at 10",
     "some spheres are farther away than that, and if nothing is hit the result has t = NO_HIT.",
     "spheres cut off where they are far away", ((Hit){10, -1}), hit_sphere, nearer)
LOOP("H3-1000", "a best t that starts at 1000",
     "a scene may be of any size, and if nothing is hit the result has t = NO_HIT.",
     "no visible difference, until a sphere is farther away than that", ((Hit){1000, -1}),
     hit_sphere, nearer)
LOOP("H3-max", "t = DBL_MAX if nothing is hit",
     "a ray that misses everything never ends: its t is NO_HIT, which is infinite.",
     "no visible difference; but a caller who tests t < NO_HIT sees a hit", ((Hit){DBL_MAX, -1}),
     hit_sphere, nearer)
LOOP("H-more", "no hit, whatever the ray",
     "does it compare with > a best t that starts at NO_HIT? NO_HIT is infinite, and no hit is "
     "farther away. Or does the loop never run?",
     "blank: background only", nothing, hit_sphere, more)
LOOP("H-miss", "the largest t, including NO_HIT",
     "the eye sees the nearest hit on a ray. And a missed sphere counts here as one that is "
     "infinitely far away.",
     "spheres at places where there are none", ((Hit){0, -1}), hit_sphere, more)
LOOP("H-far", "the farthest hit",
     "the nearest sphere covers the farther ones; the smallest t wins.",
     "the scene from back to front: far spheres in front of near ones", nothing, hit_sphere,
     hit_and_farther)

WRONG(nearest_hit, "H-centre", "the sphere whose centre is nearest",
      "the eye sees surfaces. A large sphere may come nearer than a small one whose centre is in "
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

LOOP("H-tie", "the last one of equally near spheres",
     "an equal t is not nearer. Of equal hits the lower index counts.",
     "another colour where two spheres touch or coincide", nothing, hit_sphere, nearer_or_equal)

WRONG(nearest_hit, "H-from1", "sphere 0 left out", "spheres are counted from 0.",
      "the first sphere of the scene is missing")
{
    Scene rest = *scene;
    rest.spheres += rest.sphere_count > 0;
    rest.sphere_count -= rest.sphere_count > 0;
    Hit hit = nearest_hit(ray, &rest);
    return (Hit){hit.t, hit.sphere < 0 ? -1 : hit.sphere + 1};
}

WRONG(nearest_hit, "H-last", "the last sphere left out",
      "counted from 0, the last of n spheres has the index n - 1, and it must be tested.",
      "the last sphere of the scene is missing")
{
    Scene rest = *scene;
    rest.sphere_count -= rest.sphere_count > 0;
    return nearest_hit(ray, &rest);
}

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
    "a crash, or the colour of a sphere that does not exist",
    double t = hit_sphere(ray, GUARD_SPHERE);
    return t < hit.t ? (Hit){t, scene->sphere_count} : hit)

LOOP("R6-scene", "the t where the ray leaves the sphere",
     "the ray enters a sphere before it leaves it, and the eye sees the side that faces it.",
     "spheres seen from behind; a large one may vanish behind a small one", nothing, far_root,
     nearer)
LOOP("R7-scene", "the smallest t, even if negative",
     "a ray starts at the eye. Hits with t < 0 are behind the eye.",
     "ghosts of the spheres behind the eye, mirrored and upside down", nothing, near_root, nearer)
LOOP("R8-scene", "no hit on a sphere around the eye",
     "from inside, the near side is behind the eye, but the ray still leaves through the far one.",
     "a sphere vanishes as soon as the eye enters it", nothing, near_root_in_front, nearer)
LOOP("D1-scene", "hits with t up to 1 dropped",
     "the image plane is a window, not a wall: spheres between it and the eye are visible.",
     "near spheres vanish", nothing, hit_beyond_the_plane, nearer)
LOOP("R10-scene", "hits with t up to 0.1 dropped",
     "with a long direction even a small t may be a long way.", "near spheres vanish", nothing,
     hit_beyond_a_tenth, nearer)
LOOP("R10-small", "hits with t up to 0.001 dropped",
     "with a long direction even a small t may be a long way.", "very near spheres vanish", nothing,
     hit_beyond_a_thousandth, nearer)
LOOP("H-float", "t as a float",
     "a float has 7 digits and a double 16, as many as the t of hit_sphere.",
     "speckles where surfaces nearly touch", nothing, hit_as_float, nearer)

OF_NEAREST("H-none0", "index 0 if nothing is hit", "0 is the first sphere; a miss is -1.",
           "the first sphere's colour instead of the background",
           return hit.sphere < 0 ? (Hit){NO_HIT, 0} : hit)
OF_NEAREST("H-none-1", "t = -1 if nothing is hit",
           "-1 would be behind the eye, and nearer than every hit. NO_HIT is farther than all.",
           "no visible difference; but a caller who compares t takes a miss for the nearest hit",
           return hit.sphere < 0 ? (Hit){-1, -1} : hit)
OF_NEAREST("H-way", "the distance to the hit: t times the direction's length",
           "t counts in lengths of the direction, and a direction may have any length.",
           "the same picture; the point at that t is not on the sphere",
           return (Hit){hit.t * vec3_length(ray.direction), hit.sphere})
OF_NEAREST("H-surface", "the index of the sphere's surface",
           "several spheres may share a surface, so it does not tell which of them was hit.",
           "spheres in each other's colours",
           return (Hit){hit.t, hit.sphere < 0 ? -1 : scene->spheres[hit.sphere].surface})
OF_NEAREST("H-count1", "the spheres counted from 1", "the first sphere has the index 0.",
           "each sphere in the next one's colour",
           return (Hit){hit.t, hit.sphere < 0 ? -1 : hit.sphere + 1})

WRONG_LINE(nearest_hit, "H-no-sphere", "the right t, with -1 for the sphere",
           "-1 says that nothing was hit. Return the index of the sphere with this t.",
           "blank: background only", return (Hit){nearest_hit(ray, scene).t, -1})
WRONG_LINE(nearest_hit, "H-no-t", "the last sphere that is hit, with t = NO_HIT",
           "comparing works only if you remember the best t so far together with its sphere.",
           "far spheres in front of near ones, in the order of the scene",
           return (Hit){NO_HIT, last_hit(ray, scene).sphere})
// As without the braces of an if: the statements for a hit are executed for every sphere.
WRONG_LINE(nearest_hit, "H-braces", "the right t, but the last sphere",
           "the index changes with every sphere, whether it is nearer or not. An if without braces "
           "ends after one statement.",
           "everything in the last sphere's colour",
           return (Hit){nearest_hit(ray, scene).t, scene->sphere_count - 1})

WRONG(nearest_hit, "H-break", "the spheres up to the first miss",
      "a sphere that is missed says nothing about the next one: go on.",
      "spheres missing, depending on the order of the scene")
{
    Hit best = nothing;
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t == NO_HIT)
            break;
        if (t < best.t)
            best = (Hit){t, i};
    }
    return best;
}

WRONG(nearest_hit, "H-stop", "the spheres up to the first that is not nearer",
      "a sphere that is farther away says nothing about the next one: go on.",
      "far spheres in front of near ones, in the order of the scene")
{
    Hit best = nothing;
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t < best.t)
            best = (Hit){t, i};
        else if (best.sphere >= 0)
            break;
    }
    return best;
}

WRONG(nearest_hit, "H-reset", "the hits since the last miss",
      "a sphere that is missed does not change the other hits: keep the best so far.",
      "spheres missing, depending on the order of the scene")
{
    Hit best = nothing;
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t == NO_HIT)
            best = nothing;
        else if (t < best.t)
            best = (Hit){t, i};
    }
    return best;
}

// Each is compared only with the one before it.
WRONG(nearest_hit, "H-before", "each sphere compared with the one before it",
      "compare with the nearest of all so far, and remember it.",
      "far spheres in front of near ones, in the order of the scene")
{
    Hit hit = nothing;
    double before = NO_HIT;
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t < before)
            hit = (Hit){t, i};
        before = t;
    }
    return hit;
}

WRONG_LINE(nearest_hit, "H-first-index", "the right t, but the first hit's index",
           "a nearer hit replaces both: the t and the index of its sphere.",
           "spheres in each other's colours",
           return (Hit){nearest_hit(ray, scene).t, first_hit(ray, scene).sphere})

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

OF_NEAREST("H-none-count", "sphere_count if nothing is hit",
           "the last sphere has the number sphere_count - 1, and a miss is -1.",
           "a crash, or an arbitrary colour for the background",
           return hit.sphere < 0 ? (Hit){NO_HIT, scene->sphere_count} : hit)

// ---- wrong answers to nearest_hit: limits that no scene has -------------------------------------

#define FROM_ROW(id, least, hit)                                                                   \
    LOOP(id, "hits with t up to " least " dropped",                                                \
         "t counts in lengths of the direction, and scenes are of any size: every hit with t > 0 " \
         "is in front of the eye.",                                                                \
         "right in scenes of one size, holes in others", nothing, hit, nearer)

#define UP_TO_ROW(id, most, hit)                                                                   \
    LOOP(id, "only hits with t below " most, "a scene may be of any size: every t > 0 is a hit.",  \
         "no visible difference, until a sphere is farther away than that", nothing, hit, nearer)

#define BY_ROW(id, epsilon, nothing, hit, nearer_by)                                               \
    LOOP(id, "only hits that are nearer by " epsilon,                                              \
         "scenes are of any size, and t counts in lengths of the direction: nearer is nearer, by " \
         "however little.",                                                                        \
         "right in scenes of one size, wrong colours in smaller ones", nothing, hit, nearer_by)

#define FIRST_ROW(number)                                                                          \
    WRONG(nearest_hit, "H-room" #number, "the first " #number " spheres",                          \
          "the number of spheres in the scene is sphere_count.",                                   \
          "no visible difference, until a scene has more spheres")                                 \
    {                                                                                              \
        Scene some = at_most(number, scene);                                                       \
        return nearest_hit(ray, &some);                                                            \
    }

FROM_ROW("H-1e-4", "1e-4", hit_beyond_1e_4)
FROM_ROW("H-1e-5", "1e-5", hit_beyond_1e_5)
FROM_ROW("H-1e-6", "1e-6", hit_beyond_1e_6)
FROM_ROW("H-1e-9", "1e-9", hit_beyond_1e_9)
UP_TO_ROW("H-up-100", "100", hit_before_100)
UP_TO_ROW("H-up-1000", "1000", hit_before_1000)
UP_TO_ROW("H-up-10000", "10000", hit_before_10000)
UP_TO_ROW("H-up-1e5", "1e5", hit_before_1e5)
UP_TO_ROW("H-up-1e6", "1e6", hit_before_1e6)
UP_TO_ROW("H-up-1e9", "1e9", hit_before_1e9)
UP_TO_ROW("H-up-1e10", "1e10", hit_before_1e10)
UP_TO_ROW("H-up-1e12", "1e12", hit_before_1e12)
BY_ROW("H-by-1e-3", "0.001", nothing, hit_sphere, nearer_by_a_thousandth)
BY_ROW("H-by-1e-5", "1e-5", nothing, hit_sphere, nearer_by_a_hundred_thousandth)
BY_ROW("H-by-1e-6", "1e-6", nothing, hit_sphere, nearer_by_a_millionth)
BY_ROW("H-by-1e-9", "1e-9", nothing, hit_sphere, nearer_by_a_billionth)
WRONG_LINE(nearest_hit, "H-by-float", "t compared as floats",
           "a float has 7 digits, a double 16, and spheres may be close together.",
           "speckles where surfaces nearly touch",
           return best_of(nothing, hit_sphere, nearer_as_floats, ray, scene))
FIRST_ROW(10)
FIRST_ROW(16)
FIRST_ROW(32)
FIRST_ROW(64)
FIRST_ROW(100)
FIRST_ROW(128)
FIRST_ROW(256)

// ---- slips --------------------------------------------------------------------------------------

static bool in_first_column(Pixel pixel, Resolution size)
{
    (void)size;
    return pixel.column == 0;
}

static bool in_first_row(Pixel pixel, Resolution size)
{
    (void)size;
    return pixel.row == 0;
}

static Pixel turned(Pixel pixel, Resolution size)
{
    return (Pixel){size.width - 1 - pixel.column, size.height - 1 - pixel.row};
}

static Pixel next_one(Pixel pixel, Resolution size)
{
    (void)size;
    return (Pixel){pixel.column + 1, pixel.row + 1};
}

static Pixel always_the_first(Pixel pixel, Resolution size)
{
    (void)size;
    (void)pixel;
    return (Pixel){0, 0};
}

static Color sphere_0_is_nothing(const Scene *scene, int sphere)
{
    return sphere > 0 ? flat_color(scene, sphere) : scene->background;
}

static Color always_background(const Scene *scene, int sphere)
{
    (void)sphere;
    return scene->background;
}

// ---- other loops --------------------------------------------------------------------------------

// Rays of their own, through the place s, t of each pixel.
static void cast_through(double right, double down, const Scene *scene, Camera camera, Image *image)
{
    Resolution size = image->size;
    for (int i = 0; i < size.width * size.height; i++) {
        Pixel pixel = pixel_number(i, size);
        double s = (pixel.column + right) / size.width, t = 1 - (pixel.row + down) / size.height;
        Ray ray = {camera.origin, image_plane_vector(camera, s, t)};
        image_set(image, pixel, flat_color(scene, nearest_hit(ray, scene).sphere));
    }
}

IMAGE_ORDER("I-flip", "the rows counted from the bottom",
            "row 0 of the image is the top one, and pixel_ray counts in the same way.",
            "upside down", .ray_of = row_from_below)
IMAGE_ORDER("I-mirror", "the columns counted from the right",
            "column 0 is the left one, and pixel_ray counts in the same way.", "mirrored",
            .ray_of = column_from_the_right)
IMAGE_ORDER("I-turn", "the pixels from the last to the first",
            "the ray of the lower right pixel colours the upper left one.", "turned by 180 degrees",
            .ray_of = turned)
IMAGE_ORDER("P4", "row and column swapped",
            "a pixel is (column, row): how far to the right, then how far down; here it gets the "
            "ray of (row, column).",
            "right and down swapped", .ray_of = row_and_column_swapped)
IMAGE_ORDER("I-from1", "the pixels counted from 1",
            "the first column and the first row are number 0; so each pixel shows its neighbour.",
            "shifted by a pixel, to the left and up", .ray_of = next_one)
IMAGE_ORDER("I-one", "the ray of the first pixel for all", "every pixel has its own ray.",
            "all in one colour", .ray_of = always_the_first)
IMAGE_ORDER("I-column0", "column 0 not painted", "columns are counted from 0.",
            "a stripe at the left edge", .left_out = in_first_column)
IMAGE_ORDER("I-row0", "row 0 not painted", "rows are counted from 0.", "a stripe at the upper edge",
            .left_out = in_first_row)
IMAGE_ORDER("I-column", "the last column not painted",
            "counted from 0, the last of w columns is number w - 1, and it must be painted.",
            "a stripe at the right edge", .left_out = in_last_column)
IMAGE_ORDER("I-row", "the last row not painted",
            "counted from 0, the last of h rows is number h - 1, and it must be painted.",
            "a stripe at the lower edge", .left_out = in_last_row)

WRONG(cast_image_order, "I-size", "width and height swapped",
      "a resolution is the number of columns, then the number of rows.",
      "spheres stretched, part of the scene cut off; right in a square image")
{
    Resolution size = image->size;
    for (int i = 0; i < size.width * size.height; i++) {
        Pixel pixel = pixel_number(i, size);
        Ray ray = pixel_ray(camera, (Resolution){size.height, size.width}, pixel);
        image_set(image, pixel, flat_color(scene, nearest_hit(ray, scene).sphere));
    }
}

WRONG_LINE(cast_image_order, "P1", "rays through the pixels' corners",
           "a pixel is a small square, and its ray goes through the centre: half a pixel to the "
           "right and half a pixel down.",
           "everything moved by half a pixel, to the right and down",
           cast_through(0, 0, scene, camera, image))
WRONG_LINE(cast_image_order, "P2", "rays through the lower right corners",
           "from its upper left corner to its centre it is half a pixel each way, once.",
           "everything moved by half a pixel, to the left and up",
           cast_through(1, 1, scene, camera, image))

WRONG(cast_image_order, "P7", "rays from the world's origin", "rays start at the eye.",
      "moving the camera changes nothing")
{
    camera.origin = vec3_of(0, 0, 0);
    cast_image_order(scene, camera, image);
}

IMAGE_ORDER("I-last", "the last hit of the list",
            "the distance decides which sphere covers another, not the order of the scene.",
            "far spheres in front of near ones, in the order of the scene", .replaces = any_hit)
IMAGE_ORDER("I-first", "the first hit of the list", "a sphere later in the list may be nearer.",
            "the first spheres of the scene cover everything", .replaces = hit_and_none_before)

WRONG(cast_image_order, "I-only", "sphere 0 alone",
      "each ray must be tested against every sphere of the scene.", "one sphere only")
{
    Scene first = *scene;
    first.sphere_count = scene->sphere_count > 0;
    cast_image_order(&first, camera, image);
}

IMAGE_ORDER("I-tie", "the last of equally near spheres", "of equal hits the lower index counts.",
            "another colour where two spheres touch or coincide", .replaces = nearer_or_equal)
IMAGE_ORDER("I-far", "the farthest hit", "the nearest sphere covers the farther ones.",
            "the scene from back to front", .replaces = hit_and_farther)
IMAGE_ORDER("R6-image", "spheres compared by where rays leave them",
            "the eye sees the point where the ray enters. A large sphere may start in front of a "
            "small one and end behind it.",
            "small spheres seen through large ones", .t_of = far_root)
IMAGE_ORDER("R7-image", "the smallest t, even below 0",
            "a ray starts at the eye. Hits with t < 0 are behind the eye.",
            "ghosts of the spheres behind the eye, mirrored and upside down", .t_of = near_root)
IMAGE_ORDER("R8-image", "no hit on a sphere around the eye",
            "the ray still leaves such a sphere through its far side.",
            "a sphere vanishes as soon as the eye enters it", .t_of = near_root_in_front)
IMAGE_ORDER("D1-image", "hits with t up to 1 dropped",
            "the image plane is a window, not a wall: spheres between it and the eye are visible.",
            "near spheres vanish", .t_of = hit_beyond_the_plane)
IMAGE_ORDER("I-rest", "only hits painted",
            "if nothing is hit, the old colour of the image stays. Every pixel needs a colour.",
            "spheres on the old contents of the image, at first black", .no_background = true)

WRONG(cast_image_order, "I-break", "a row given up at its first miss",
      "a ray that hits nothing says nothing about the next one. Its own pixel needs a colour as "
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

IMAGE_ORDER("I-none", "the background everywhere",
            "no hit ever colours its pixel. How do you distinguish a hit from a miss?", "blank",
            .color = always_background)
IMAGE_ORDER("I-0", "index 0 treated as a miss", "0 is the first sphere; a miss is -1.",
            "a hole in the shape of the first sphere", .color = sphere_0_is_nothing)

// ---- slips --------------------------------------------------------------------------------------

static void background_where_missed(const Scene *scene, Camera camera, Image *image, double *depth)
{
    cast_with((Slips){.background_where_missed = true}, scene, camera, image, depth);
}

static void background_where_farther(const Scene *scene, Camera camera, Image *image, double *depth)
{
    cast_with((Slips){.background_where_farther = true}, scene, camera, image, depth);
}

// ---- other loops --------------------------------------------------------------------------------

OBJECT_ORDER("D1-object", "hits with t up to 1 dropped",
             "the image plane is a window, not a wall: spheres between it and the eye are visible.",
             "near spheres vanish", .t_of = hit_beyond_the_plane)
OBJECT_ORDER(
    "R6-object", "the t where the ray leaves the sphere",
    "the ray enters a sphere before it leaves it, and the eye sees the side that faces it.",
    "small spheres seen through large ones", .t_of = far_root)
OBJECT_ORDER("R7-object", "the smallest t, even below 0",
             "a ray starts at the eye. Hits with t < 0 are behind the eye.",
             "ghosts of the spheres behind the eye, mirrored and upside down", .t_of = near_root)
OBJECT_ORDER("R8-object", "no hit on a sphere around the eye",
             "the ray still leaves such a sphere through its far side.",
             "a sphere vanishes as soon as the eye enters it", .t_of = near_root_in_front)
OBJECT_ORDER("O-rest", "only hits painted",
             "if nothing is hit, the old colour of the image stays. Every pixel needs a colour.",
             "spheres on the old contents of the image, at first black", .no_background = true)
WRONG_BY(background_where_missed, cast_object_order, "O-wipe",
         "each sphere erases the pixels where it is missed",
         "another sphere may already be visible there. A miss says nothing about the others.",
         "only the last sphere")
WRONG_BY(background_where_farther, cast_object_order, "O-else",
         "each sphere erases the pixels where it is not the nearest so far",
         "the colours of other spheres must stay. Paint the background once, before all spheres.",
         "the last sphere, with holes where others are in front of it")

// As without the braces of an if: the statements for nearer hits are executed for every pixel.
WRONG(cast_object_order, "O-braces", "every sphere paints every pixel",
      "the depths are right, but the colour changes whether the sphere is nearer or not. An if "
      "without braces ends after one statement.",
      "everything in the last sphere's colour")
{
    cast_object_order(scene, camera, image, depth);
    for (int i = 0; i < image->size.width * image->size.height; i++)
        image_set(image, pixel_number(i, image->size), flat_color(scene, scene->sphere_count - 1));
}

OBJECT_ORDER("O-from1", "sphere 0 left out", "spheres are counted from 0.",
             "the first sphere of the scene is missing", .first_sphere = 1)
OBJECT_ORDER("O-last", "the last sphere left out",
             "counted from 0, the last of n spheres has the index n - 1, and it must be tested.",
             "the last sphere of the scene is missing", .last_sphere = 1)

WRONG(cast_object_order, "O-only", "sphere 0 alone", "every sphere of the scene must be tested.",
      "one sphere only")
{
    Scene first = *scene;
    first.sphere_count = scene->sphere_count > 0;
    cast_object_order(&first, camera, image, depth);
}

OBJECT_ORDER("O-row", "no sphere in the last row",
             "counted from 0, the last of h rows is number h - 1, and it must be painted.",
             "a stripe of background at the lower edge", .left_out = in_last_row)
OBJECT_ORDER("O-column", "no sphere in the last column",
             "counted from 0, the last of w columns is number w - 1, and it must be painted.",
             "a stripe of background at the right edge", .left_out = in_last_column)
OBJECT_ORDER("O-flip", "the rows counted from the bottom",
             "row 0 of the image is the top one, and pixel_ray counts in the same way.",
             "upside down", .ray_of = row_from_below)
OBJECT_ORDER("O-mirror", "the columns counted from the right",
             "column 0 is the left one, and pixel_ray counts in the same way.", "mirrored",
             .ray_of = column_from_the_right)
OBJECT_ORDER("P4-object", "row and column swapped",
             "a pixel is (column, row): how far to the right, then how far down; here it gets the "
             "ray of (row, column).",
             "right and down swapped", .ray_of = row_and_column_swapped)

WRONG(cast_object_order, "P7-object", "rays from the world's origin", "rays start at the eye.",
      "moving the camera changes nothing")
{
    camera.origin = vec3_of(0, 0, 0);
    cast_object_order(scene, camera, image, depth);
}

// ---- wrong answers to both orders: the colours --------------------------------------------------

static Color surface_of_that_number(const Scene *scene, int sphere)
{
    return sphere < 0 ? scene->background : scene->surfaces[sphere % scene->surface_count].color;
}

static Color first_surface(const Scene *scene, int sphere)
{
    return sphere < 0 ? scene->background : scene->surfaces[0].color;
}

static Color blue_green_red(const Scene *scene, int sphere)
{
    Color color = flat_color(scene, sphere);
    return vec3_of(color[2], color[1], color[0]);
}

static Color times_255(const Scene *scene, int sphere)
{
    return 255 * flat_color(scene, sphere);
}

static Color black_background(const Scene *scene, int sphere)
{
    return sphere < 0 ? vec3_of(0, 0, 0) : flat_color(scene, sphere);
}

static Color through_255(const Scene *scene, int sphere)
{
    return flat_color(scene, sphere) / 255;
}

// The background unchanged.
static Color surface_times_255(const Scene *scene, int sphere)
{
    return sphere < 0 ? scene->background : times_255(scene, sphere);
}

static Color surface_through_255(const Scene *scene, int sphere)
{
    return sphere < 0 ? scene->background : through_255(scene, sphere);
}

static Color ambient_background(const Scene *scene, int sphere)
{
    return sphere < 0 ? scene->ambient : flat_color(scene, sphere);
}

static Color white_background(const Scene *scene, int sphere)
{
    return sphere < 0 ? vec3_of(1, 1, 1) : flat_color(scene, sphere);
}

static Color background_of_surface_0(const Scene *scene, int sphere)
{
    return sphere < 0 ? scene->surfaces[0].color : flat_color(scene, sphere);
}

static Color in_whole_numbers(const Scene *scene, int sphere)
{
    Color color = flat_color(scene, sphere);
    return vec3_of(trunc(color[0]), trunc(color[1]), trunc(color[2]));
}

static Color all_white(const Scene *scene, int sphere)
{
    (void)scene, (void)sphere;
    return vec3_of(1, 1, 1);
}

static Color all_black(const Scene *scene, int sphere)
{
    (void)scene, (void)sphere;
    return vec3_of(0, 0, 0);
}

static Color times_kd(const Scene *scene, int sphere)
{
    double kd = sphere < 0 ? 1 : scene_surface(scene, sphere)->diffuse;
    return kd * flat_color(scene, sphere);
}

static Color encoded(const Scene *scene, int sphere)
{
    Color color = flat_color(scene, sphere);
    return vec3_of(pow(color[0], 1 / 2.2), pow(color[1], 1 / 2.2), pow(color[2], 1 / 2.2));
}

static Color green_red_blue(const Scene *scene, int sphere)
{
    Color color = flat_color(scene, sphere);
    return vec3_of(color[1], color[0], color[2]);
}

static Color grey_of_it(const Scene *scene, int sphere)
{
    Color color = flat_color(scene, sphere);
    double mean = (color[0] + color[1] + color[2]) / 3;
    return vec3_of(mean, mean, mean);
}

// The same slip in both orders.
#define BOTH(id, formula, why, picture, ...)                                                       \
    IMAGE_ORDER("I-" id, formula, why, picture, __VA_ARGS__)                                       \
    OBJECT_ORDER("O-" id, formula, why, picture, __VA_ARGS__)

BOTH("black", "black if nothing is hit", "the scene has its own background colour.",
     "spheres on black", .color = black_background)
BOTH("index", "the surface of the sphere's number",
     "spheres and surfaces are numbered separately; each sphere has the number of its surface.",
     "spheres in each other's colours", .color = surface_of_that_number)
BOTH("white", "always surface 0", "each sphere has the number of its surface.",
     "all spheres in one colour", .color = first_surface)
BOTH("bgr", "blue, green, red", "the first of the three numbers is red.", "red and blue swapped",
     .color = blue_green_red)
BOTH("255", "colours times 255", "colours go from 0 to 1; the image converts them to bytes.",
     "everything that is not black is too bright", .color = times_255)
BOTH("1/255", "colours divided by 255",
     "colours already go from 0 to 1; the image converts them to bytes.", "nearly black",
     .color = through_255)
BOTH("255-surface", "the surface's colour times 255",
     "colours go from 0 to 1, also those of surfaces; the image converts them to bytes.",
     "spheres too bright on the right background", .color = surface_times_255)
BOTH("1/255-surface", "the surface's colour divided by 255",
     "colours already go from 0 to 1, also those of surfaces; the image converts them to bytes.",
     "nearly black spheres on the right background", .color = surface_through_255)
BOTH("ambient", "the ambient light if nothing is hit",
     "the scene has both, and they differ: use its background.", "spheres on another background",
     .color = ambient_background)
BOTH("white-sky", "white if nothing is hit", "the scene has its own background colour.",
     "spheres on white", .color = white_background)
BOTH("sky-surface", "the colour of surface 0 if nothing is hit",
     "only spheres have surfaces; the scene has its own background colour.",
     "spheres on another background", .color = background_of_surface_0)
BOTH("int", "colours without the digits after the decimal point",
     "colours are numbers from 0 to 1, mostly in between: keep them in a Color or in doubles.",
     "black, except where a colour is 1", .color = in_whole_numbers)
BOTH("all-white", "white everywhere",
     "the scene has the colours of its background and of each surface.", "white",
     .color = all_white)
BOTH("all-black", "black everywhere",
     "the scene has the colours of its background and of each surface.", "black",
     .color = all_black)
BOTH("kd", "kd times the surface's colour", "kd is used in chapter 07: here colours are flat.",
     "spheres too dark", .color = times_kd)
BOTH("gamma", "colours to the power of 1 / 2.2",
     "the image takes colours unchanged: no gamma here.", "everything too pale", .color = encoded)
BOTH("grb", "green, red, blue", "the first of the three numbers is red.", "red and green swapped",
     .color = green_red_blue)
BOTH("grey", "the mean of red, green and blue", "each of the three has its own byte in the image.",
     "a grey picture", .color = grey_of_it)

// ---- slips --------------------------------------------------------------------------------------

static bool hit_and_more(double t, double depth)
{
    return t < NO_HIT && t > depth;
}

static int column_by_column(Pixel pixel, Resolution size)
{
    return pixel.column * size.height + pixel.row;
}

static int from_the_bottom(Pixel pixel, Resolution size)
{
    return (size.height - 1 - pixel.row) * size.width + pixel.column;
}

static int times_the_height(Pixel pixel, Resolution size)
{
    return pixel.row * size.height + pixel.column;
}

static int one_row_for_all(Pixel pixel, Resolution size)
{
    (void)size;
    return pixel.column;
}

static int one_for_all(Pixel pixel, Resolution size)
{
    (void)size;
    (void)pixel;
    return 0;
}

static void depth_not_stored(const Scene *scene, Camera camera, Image *image, double *depth)
{
    cast_with((Slips){.depth_not_stored = true}, scene, camera, image, depth);
}

// ---- other loops --------------------------------------------------------------------------------

static void none_is(double t, const Scene *scene, Camera camera, Image *image, double *depth)
{
    cast_object_order(scene, camera, image, depth);
    for (int i = 0; i < image->size.width * image->size.height; i++)
        depth[i] = depth[i] < NO_HIT ? depth[i] : t;
}

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

OBJECT_ORDER("Z-kept", "depths that are never initialised",
             "the values in depth before the call are arbitrary. Before the first sphere nothing "
             "has been hit: set every depth to NO_HIT.",
             "holes, or nothing at all, and at other times no visible difference",
             .depth_kept = true)
OBJECT_ORDER("Z-minus", "depths that start at -1",
             "hits are in front of the eye, t > 0, so none is ever below -1.", "blank",
             .depth_starts_elsewhere = true, .depth_start = -1)
OBJECT_ORDER("Z-0", "depths that start at 0",
             "hits are in front of the eye, t > 0, so none is ever below 0.", "blank",
             .depth_starts_elsewhere = true, .depth_start = 0)
OBJECT_ORDER("Z-1000", "depths that start at 1000",
             "a scene may be of any size. If nothing is hit the depth is NO_HIT.",
             "no visible difference, until a sphere is farther away than that",
             .depth_starts_elsewhere = true, .depth_start = 1000)

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

WRONG_BY(
    depth_not_stored, cast_object_order, "Z-never", "depths that are never changed",
    "each sphere is compared with NO_HIT. A pixel must remember the t of its nearest hit so far.",
    "far spheres in front of near ones, in the order of the scene")
OBJECT_ORDER("H1-object", "each sphere painted wherever it is hit",
             "was something nearer hit in that pixel before? The depth answers that.",
             "far spheres in front of near ones, in the order of the scene", .replaces = any_hit)
OBJECT_ORDER("Z-first", "pixels painted only once",
             "a sphere later in the list may be nearer, and covers the colour that is there.",
             "the first spheres of the scene cover everything", .replaces = hit_and_none_before)
OBJECT_ORDER("Z-tie", "painted over at equal depths",
             "an equal t is not nearer. Of equal hits the lower index counts.",
             "another colour where two spheres touch or coincide", .replaces = nearer_or_equal)
OBJECT_ORDER("Z-far", "the farthest hit", "the nearest sphere covers the farther ones.",
             "the scene from back to front", .replaces = hit_and_farther)
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
WRONG_LINE(cast_object_order, "Z-height", "depth[row * height + column]",
           "a row is as long as the image is wide: row * width pixels come before it.",
           "right in a square image; in others parts of spheres are missing",
           rows_of_the_height(true, scene, camera, image, depth))
WRONG_LINE(cast_object_order, "Z-height-set",
           "depth[row * height + column], also in the loop that initialises it",
           "a row is as long as the image is wide: row * width pixels come before it.",
           "right in a square image; in others parts of spheres are missing",
           rows_of_the_height(false, scene, camera, image, depth))
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

WRONG(cast_object_order, "Z-way", "the distance to the hit",
      "the depth is t, which counts in lengths of the ray's direction; and these differ from pixel "
      "to pixel.",
      "the same picture")
{
    Resolution size = image->size;
    cast_object_order(scene, camera, image, depth);
    for (int i = 0; i < size.width * size.height; i++)
        depth[i] *= vec3_length(pixel_ray(camera, size, pixel_number(i, size)).direction);
}

WRONG_LINE(cast_object_order, "Z-none0", "a depth of 0 if nothing is hit",
           "0 is at the eye, nearer than all hits. A miss is infinitely far away: NO_HIT.",
           "the same picture", none_is(0, scene, camera, image, depth))
WRONG_LINE(cast_object_order, "Z-none-1", "-1 if nothing is hit",
           "-1 is behind the eye. A miss is infinitely far away: NO_HIT.", "the same picture",
           none_is(-1, scene, camera, image, depth))

WRONG(cast_object_order, "Z-own", "depths in an array of your own",
      "the picture is right, but the caller also needs the depths, in the array depth.",
      "the same picture")
{
    double *own = depth_for(image);
    cast_object_order(scene, camera, image, own);
    free(own);
}

// ---- other pictures -----------------------------------------------------------------------------

// Rays of their own, through the places of the pixels on the plane.
static void cast_places(bool less_1, const Scene *scene, Camera camera, Image *image, double *depth)
{
    Resolution size = image->size;
    for (int i = 0; i < size.width * size.height; i++) {
        Pixel pixel = pixel_number(i, size);
        double s = (pixel.column + (less_1 ? 0 : 0.5)) / (less_1 ? size.width - 1 : size.width);
        double t = 1 - (pixel.row + (less_1 ? 0 : 0.5)) / (less_1 ? size.height - 1 : size.height);
        Hit hit = nearest_hit((Ray){camera.origin, image_plane_vector(camera, s, t)}, scene);
        image_set(image, pixel, flat_color(scene, hit.sphere));
        if (depth != NULL)
            depth[i] = hit.t;
    }
}

static void image_through_width_less_1(const Scene *scene, Camera camera, Image *image)
{
    cast_places(true, scene, camera, image, NULL);
}

static void object_through_width_less_1(const Scene *scene, Camera camera, Image *image,
                                        double *depth)
{
    cast_places(true, scene, camera, image, depth);
}

// The camera's height computed from the picture's shape, or its width.
static Camera shaped(bool width, Camera camera, Resolution size)
{
    if (width)
        camera.width = camera.height * size.width / size.height;
    else
        camera.height = camera.width * size.height / size.width;
    return camera;
}

// ---- depths -------------------------------------------------------------------------------------

static void starting_at(double t, const Scene *scene, Camera camera, Image *image, double *depth)
{
    cast_with((Slips){.depth_starts_elsewhere = true, .depth_start = t}, scene, camera, image,
              depth);
}

#define STARTS(id, formula, why, picture, t)                                                       \
    WRONG(cast_object_order, id, formula, why, picture)                                            \
    {                                                                                              \
        starting_at(t, scene, camera, image, depth);                                               \
    }

#define BOTH_BY(id, slip, formula, why, picture)                                                   \
    WRONG_BY(image_##slip, cast_image_order, "I-" id, formula, why, picture)                       \
    WRONG_BY(object_##slip, cast_object_order, "O-" id, formula, why, picture)

// Right for another scene or camera.
#define CHANGED(id, formula, why, picture, change)                                                 \
    WRONG(cast_image_order, "I-" id, formula, why, picture)                                        \
    {                                                                                              \
        change;                                                                                    \
        cast_image_order(scene, camera, image);                                                    \
    }                                                                                              \
    WRONG(cast_object_order, "O-" id, formula, why, picture)                                       \
    {                                                                                              \
        change;                                                                                    \
        cast_object_order(scene, camera, image, depth);                                            \
    }

#define FROM(least, ...)                                                                           \
    BOTH("t-" least, "hits with t up to " least " dropped",                                        \
         "t counts in lengths of the direction, and scenes are of any size: every hit with t > 0 " \
         "is in front of the eye.",                                                                \
         "right in scenes of one size, holes in others", __VA_ARGS__)

#define UP_TO(most, ...)                                                                           \
    BOTH("up-" most, "only hits with t below " most,                                               \
         "a scene may be of any size: every t > 0 is a hit.",                                      \
         "no visible difference, until a sphere is farther away than that", __VA_ARGS__)

#define BY(epsilon, ...)                                                                           \
    BOTH("by-" epsilon, "only hits that are nearer by " epsilon,                                   \
         "scenes are of any size, and t counts in lengths of the direction: nearer is nearer, by " \
         "however little.",                                                                        \
         "right in scenes of one size, wrong colours in smaller ones", __VA_ARGS__)

#define ROOM(number)                                                                               \
    CHANGED("room" #number, "the first " #number " spheres",                                       \
            "the number of spheres in the scene is sphere_count.",                                 \
            "no visible difference, until a scene has more spheres",                               \
            Scene some = at_most(number, scene);                                                   \
            scene = &some)

#define STARTS_ROW(t, start)                                                                       \
    STARTS("Z-" t, "depths that start at " t,                                                      \
           "a scene may be of any size. If nothing is hit the depth is NO_HIT.",                   \
           "no visible difference, until a sphere is farther away than that", start)

FROM("0.001", .t_of = hit_beyond_a_thousandth)
FROM("1e-4", .t_of = hit_beyond_1e_4)
FROM("1e-5", .t_of = hit_beyond_1e_5)
FROM("1e-6", .t_of = hit_beyond_1e_6)
FROM("1e-9", .t_of = hit_beyond_1e_9)
UP_TO("1000", .t_of = hit_before_1000)
UP_TO("1e6", .t_of = hit_before_1e6)
UP_TO("1e9", .t_of = hit_before_1e9)
UP_TO("1e12", .t_of = hit_before_1e12)
BY("0.001", .replaces = nearer_by_a_thousandth)
BY("1e-6", .replaces = nearer_by_a_millionth)
BY("1e-9", .replaces = nearer_by_a_billionth)
BOTH("by-float", "t compared as floats",
     "a float has 7 digits, a double 16, and spheres may be close together.",
     "speckles where surfaces nearly touch", .replaces = nearer_as_floats)
ROOM(10)
ROOM(16)
ROOM(32)
ROOM(64)
ROOM(100)
ROOM(128)
ROOM(256)
BOTH_BY(
    "N3", through_width_less_1, "divided by width - 1 and height - 1",
    "w pixels are w steps wide, and the ray goes through the centre of its pixel: use pixel_ray.",
    "slightly too large; nothing in an image of one row or one column")
CHANGED("height-shape", "the height of the image plane from the image's shape",
        "the camera gives the height of its plane. pixel_ray uses it unchanged.",
        "stretched if pixels are not square", camera = shaped(false, camera, image->size))
CHANGED("width-shape", "the width of the image plane from the image's shape",
        "the camera gives the width of its plane. pixel_ray uses it unchanged.",
        "stretched if pixels are not square", camera = shaped(true, camera, image->size))
CHANGED("plane1", "an image plane 1 away",
        "the camera gives the distance of its plane. pixel_ray uses it unchanged.",
        "spheres too small or too large, unless the distance is 1", camera.distance = 1)

// The colour of a hit is kept for the next pixels of the row and below.
WRONG(cast_image_order, "I-kept", "the colour of the last hit if nothing is hit",
      "if nothing is hit, the pixel has the background's colour: set it for each pixel.",
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
      "the w * h pixels have the numbers 0 to w * h - 1, and the last one must be painted.",
      "a dot in the lower right corner")
{
    Resolution size = image->size;
    Pixel last = {size.width - 1, size.height - 1};
    uint8_t *bytes = image_bytes(image, last), kept[3] = {bytes[0], bytes[1], bytes[2]};
    cast_image_order(scene, camera, image);
    for (int i = 0; i < 3; i++)
        bytes[i] = kept[i];
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

STARTS_ROW("100", 100)
STARTS_ROW("1e6", 1e6)
STARTS_ROW("1e9", 1e9)
STARTS_ROW("1e30", 1e30)
STARTS("Z-max", "DBL_MAX if nothing is hit",
       "a ray that misses everything never ends: its t is NO_HIT, which is infinite.",
       "the same picture; but a caller who tests t < NO_HIT sees a hit", 1.7976931348623157e308)
