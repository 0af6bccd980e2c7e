// mistakes-nearest.c - wrong answers to nearest_hit.
#include "tests/06-ray-casting/mistakes-limits.h"
#include "tests/judge/wire.h"

#include <float.h>

// ---- one loop, and possible slips in it ---------------------------------------------------------

static bool more(double t, double best)
{
    return t > best;
}

LOOP(last_hit, nothing, hit_sphere, any_hit)
LOOP(first_hit, nothing, hit_sphere, hit_and_none_before)
LOOP(higher_index_of_equals, nothing, hit_sphere, nearer_or_equal)
LOOP(farthest, nothing, hit_sphere, hit_and_farther)
LOOP(never_beyond_infinity, nothing, hit_sphere, more)
LOOP(misses_win, ((Hit){0, -1}), hit_sphere, more)
LOOP(best_starts_at_minus_1, ((Hit){-1, -1}), hit_sphere, nearer)
LOOP(best_starts_at_0, ((Hit){0, -1}), hit_sphere, nearer)
LOOP(best_is_all_zeros, ((Hit){0, 0}), hit_sphere, nearer)
LOOP(best_starts_at_10, ((Hit){10, -1}), hit_sphere, nearer)
LOOP(best_starts_at_1000, ((Hit){1000, -1}), hit_sphere, nearer)
LOOP(best_starts_at_the_largest, ((Hit){DBL_MAX, -1}), hit_sphere, nearer)
LOOP(behind_the_eye_too, nothing, near_root, nearer)
LOOP(nothing_from_inside, nothing, near_root_in_front, nearer)
LOOP(where_spheres_end, nothing, far_root, nearer)
LOOP(from_the_image_plane, nothing, hit_beyond_the_plane, nearer)
LOOP(from_a_tenth, nothing, hit_beyond_a_tenth, nearer)
LOOP(from_a_thousandth, nothing, hit_beyond_a_thousandth, nearer)
LOOP(in_single_precision, nothing, hit_as_float, nearer)

// ---- other loops --------------------------------------------------------------------------------

static Hit without_the_first(Ray ray, const Scene *scene)
{
    Scene rest = *scene;
    rest.spheres += rest.sphere_count > 0;
    rest.sphere_count -= rest.sphere_count > 0;
    Hit hit = nearest_hit(ray, &rest);
    return (Hit){hit.t, hit.sphere < 0 ? -1 : hit.sphere + 1};
}

static Hit without_the_last(Ray ray, const Scene *scene)
{
    Scene rest = *scene;
    rest.sphere_count -= rest.sphere_count > 0;
    return nearest_hit(ray, &rest);
}

// The guard of the answering process comes after the last sphere.
static Hit one_too_many(Ray ray, const Scene *scene)
{
    Hit hit = nearest_hit(ray, scene);
    double t = hit_sphere(ray, GUARD_SPHERE);
    return t < hit.t ? (Hit){t, scene->sphere_count} : hit;
}

static Hit until_one_is_missed(Ray ray, const Scene *scene)
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

static Hit until_one_is_farther(Ray ray, const Scene *scene)
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

static Hit forgotten_at_a_miss(Ray ray, const Scene *scene)
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
static Hit nearer_than_the_one_before(Ray ray, const Scene *scene)
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

static Hit first_of_the_hits(Ray ray, const Scene *scene)
{
    return (Hit){nearest_hit(ray, scene).t, first_hit(ray, scene).sphere};
}

static Hit nearest_either_way(Ray ray, const Scene *scene)
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

static Hit from_the_origin(Ray ray, const Scene *scene)
{
    ray.origin = vec3_of(0, 0, 0);
    return nearest_hit(ray, scene);
}

static Hit count_for_nothing(Ray ray, const Scene *scene)
{
    Hit hit = nearest_hit(ray, scene);
    return hit.sphere < 0 ? (Hit){NO_HIT, scene->sphere_count} : hit;
}

static Hit nearest_centre(Ray ray, const Scene *scene)
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

// ---- the right sphere, but a wrong result ------------------------------------------------------

static Hit index_0_for_nothing(Ray ray, const Scene *scene)
{
    Hit hit = nearest_hit(ray, scene);
    return hit.sphere < 0 ? (Hit){NO_HIT, 0} : hit;
}

static Hit minus_1_for_no_hit(Ray ray, const Scene *scene)
{
    Hit hit = nearest_hit(ray, scene);
    return hit.sphere < 0 ? (Hit){-1, -1} : hit;
}

static Hit way_for_t(Ray ray, const Scene *scene)
{
    Hit hit = nearest_hit(ray, scene);
    return (Hit){hit.t * vec3_length(ray.direction), hit.sphere};
}

static Hit surface_for_sphere(Ray ray, const Scene *scene)
{
    Hit hit = nearest_hit(ray, scene);
    return (Hit){hit.t, hit.sphere < 0 ? -1 : scene->spheres[hit.sphere].surface};
}

static Hit counted_from_1(Ray ray, const Scene *scene)
{
    Hit hit = nearest_hit(ray, scene);
    return (Hit){hit.t, hit.sphere < 0 ? -1 : hit.sphere + 1};
}

static Hit sphere_forgotten(Ray ray, const Scene *scene)
{
    return (Hit){nearest_hit(ray, scene).t, -1};
}

static Hit t_forgotten(Ray ray, const Scene *scene)
{
    return (Hit){NO_HIT, last_hit(ray, scene).sphere};
}

// As without the braces of an if: the statements for a hit are executed for every sphere.
static Hit always_the_last_index(Ray ray, const Scene *scene)
{
    return (Hit){nearest_hit(ray, scene).t, scene->sphere_count - 1};
}

const Mistake nearest_mistakes[] = {
    MISTAKE("H1", nearest_hit, last_hit, "the last sphere of the list that is hit",
            "each hit replaces the one before, even a nearer one. The distance decides which "
            "sphere covers another, not the order of the scene.",
            "far spheres in front of near ones, in the order of the scene"),
    MISTAKE("H1-first", nearest_hit, first_hit, "the first sphere of the list that is hit",
            "the search stops too early: a sphere later in the list may be nearer.",
            "the first spheres of the scene cover everything"),
    MISTAKE("H3", nearest_hit, best_starts_at_minus_1, "a best t that starts at -1",
            "hits are in front of the eye, t > 0, so none is ever below -1.",
            "blank: background only"),
    MISTAKE("H3-0", nearest_hit, best_starts_at_0, "a best t that starts at 0",
            "hits are in front of the eye, t > 0, so none is ever below 0.",
            "blank: background only"),
    MISTAKE("H3-zeros", nearest_hit, best_is_all_zeros, "all zeros: t = 0 on sphere 0",
            "this means that sphere 0 touches the eye, and nothing can be nearer than that.",
            "sphere 0's colour everywhere"),
    MISTAKE(
        "H3-10", nearest_hit, best_starts_at_10, "a best t that starts at 10",
        "some spheres are farther away than that, and if nothing is hit the result has t = NO_HIT.",
        "spheres cut off where they are far away"),
    MISTAKE("H3-1000", nearest_hit, best_starts_at_1000, "a best t that starts at 1000",
            "a scene may be of any size, and if nothing is hit the result has t = NO_HIT.",
            "no visible difference, until a sphere is farther away than that"),
    MISTAKE("H3-max", nearest_hit, best_starts_at_the_largest, "t = DBL_MAX if nothing is hit",
            "a ray that misses everything never ends: its t is NO_HIT, which is infinite.",
            "no visible difference; but a caller who tests t < NO_HIT sees a hit"),
    MISTAKE("H-more", nearest_hit, never_beyond_infinity, "hits whose t is more than NO_HIT",
            "NO_HIT is infinite; no hit is farther away than that.", "blank: background only"),
    MISTAKE("H-miss", nearest_hit, misses_win, "the largest t, including NO_HIT",
            "the eye sees the nearest hit on a ray. And a missed sphere counts here as one that is "
            "infinitely far away.",
            "spheres at places where there are none"),
    MISTAKE("H-far", nearest_hit, farthest, "the farthest hit",
            "the nearest sphere covers the farther ones; the smallest t wins.",
            "the scene from back to front: far spheres in front of near ones"),
    MISTAKE("H-centre", nearest_hit, nearest_centre, "the sphere whose centre is nearest",
            "the eye sees surfaces. A large sphere may come nearer than a small one whose centre "
            "is in front of its own.",
            "spheres that intersect are cut at the wrong place"),
    MISTAKE("H-tie", nearest_hit, higher_index_of_equals, "the last one of equally near spheres",
            "an equal t is not nearer. Of equal hits the lower index counts.",
            "another colour where two spheres touch or coincide"),
    MISTAKE("H-from1", nearest_hit, without_the_first, "sphere 0 left out",
            "spheres are counted from 0.", "the first sphere of the scene is missing"),
    MISTAKE("H-last", nearest_hit, without_the_last, "the last sphere left out",
            "counted from 0, the last of n spheres has the index n - 1, and it must be tested.",
            "the last sphere of the scene is missing"),
    MISTAKE("H-count", nearest_hit, one_too_many, "a loop up to i <= sphere_count",
            "n spheres have the numbers 0 to n - 1. There is no sphere number sphere_count: "
            "reading past the end of an array can give anything.",
            "a crash, or the colour of a sphere that does not exist"),
    MISTAKE("R6-scene", nearest_hit, where_spheres_end, "the t where the ray leaves the sphere",
            "the ray enters a sphere before it leaves it, and the eye sees the side that faces it.",
            "spheres seen from behind; a large one may vanish behind a small one"),
    MISTAKE("R7-scene", nearest_hit, behind_the_eye_too, "the smallest t, even if negative",
            "a ray starts at the eye. Hits with t < 0 are behind the eye.",
            "ghosts of the spheres behind the eye, mirrored and upside down"),
    MISTAKE("R8-scene", nearest_hit, nothing_from_inside, "no hit on a sphere around the eye",
            "from inside, the near side is behind the eye, but the ray still leaves through the "
            "far one.",
            "a sphere vanishes as soon as the eye enters it"),
    MISTAKE("D1-scene", nearest_hit, from_the_image_plane, "hits with t up to 1 dropped",
            "the image plane is a window, not a wall: spheres between it and the eye are visible.",
            "near spheres vanish"),
    MISTAKE("R10-scene", nearest_hit, from_a_tenth, "hits with t up to 0.1 dropped",
            "with a long direction even a small t may be a long way.", "near spheres vanish"),
    MISTAKE("R10-small", nearest_hit, from_a_thousandth, "hits with t up to 0.001 dropped",
            "with a long direction even a small t may be a long way.", "very near spheres vanish"),
    MISTAKE("H-float", nearest_hit, in_single_precision, "t as a float",
            "a float has 7 digits and a double 16, as many as the t of hit_sphere.",
            "speckles where surfaces nearly touch"),
    MISTAKE("H-none0", nearest_hit, index_0_for_nothing, "index 0 if nothing is hit",
            "0 is the first sphere; a miss is -1.",
            "the first sphere's colour instead of the background"),
    MISTAKE("H-none-1", nearest_hit, minus_1_for_no_hit, "t = -1 if nothing is hit",
            "-1 would be behind the eye, and nearer than every hit. NO_HIT is farther than all.",
            "no visible difference; but a caller who compares t takes a miss for the nearest hit"),
    MISTAKE("H-way", nearest_hit, way_for_t,
            "the distance to the hit: t times the direction's length",
            "t counts in lengths of the direction, and a direction may have any length.",
            "the same picture; the point at that t is not on the sphere"),
    MISTAKE("H-surface", nearest_hit, surface_for_sphere, "the index of the sphere's surface",
            "several spheres may share a surface, so it does not tell which of them was hit.",
            "spheres in each other's colours"),
    MISTAKE("H-count1", nearest_hit, counted_from_1, "the spheres counted from 1",
            "the first sphere has the index 0.", "each sphere in the next one's colour"),
    MISTAKE("H-no-sphere", nearest_hit, sphere_forgotten, "the right t, with -1 for the sphere",
            "-1 says that nothing was hit. Return the index of the sphere with this t.",
            "blank: background only"),
    MISTAKE("H-no-t", nearest_hit, t_forgotten, "the last sphere that is hit, with t = NO_HIT",
            "comparing works only if you remember the best t so far together with its sphere.",
            "far spheres in front of near ones, in the order of the scene"),
    MISTAKE("H-braces", nearest_hit, always_the_last_index, "the right t, but the last sphere",
            "the index changes with every sphere, whether it is nearer or not. An if without "
            "braces ends after one statement.",
            "everything in the last sphere's colour"),
    MISTAKE("H-break", nearest_hit, until_one_is_missed, "the spheres up to the first miss",
            "a sphere that is missed says nothing about the next one: go on.",
            "spheres missing, depending on the order of the scene"),
    MISTAKE("H-stop", nearest_hit, until_one_is_farther,
            "the spheres up to the first that is not nearer",
            "a sphere that is farther away says nothing about the next one: go on.",
            "far spheres in front of near ones, in the order of the scene"),
    MISTAKE("H-reset", nearest_hit, forgotten_at_a_miss, "the hits since the last miss",
            "a sphere that is missed does not change the other hits: keep the best so far.",
            "spheres missing, depending on the order of the scene"),
    MISTAKE("H-before", nearest_hit, nearer_than_the_one_before,
            "each sphere compared with the one before it",
            "compare with the nearest of all so far, and remember it.",
            "far spheres in front of near ones, in the order of the scene"),
    MISTAKE("H-first-index", nearest_hit, first_of_the_hits,
            "the right t, but the first hit's index",
            "a nearer hit replaces both: the t and the index of its sphere.",
            "spheres in each other's colours"),
    MISTAKE("H-abs", nearest_hit, nearest_either_way, "the smallest |t|",
            "a ray starts at the eye. Hits with t < 0 are behind the eye, however near.",
            "ghosts of the spheres behind the eye, mirrored and upside down"),
    MISTAKE("P7-scene", nearest_hit, from_the_origin, "the ray from the world's origin",
            "a ray starts at its origin.", "moving the camera changes nothing"),
    MISTAKE("H-none-count", nearest_hit, count_for_nothing, "sphere_count if nothing is hit",
            "the last sphere has the number sphere_count - 1, and a miss is -1.",
            "a crash, or an arbitrary colour for the background"),
    {0},
};
