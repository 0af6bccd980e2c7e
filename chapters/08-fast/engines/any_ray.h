// any_ray.h - rays that start anywhere: each asks 16 boxes at once, and then 16 spheres at once.
//
// Boxes and spheres are floats, with margins for rounding. A sphere that floats cannot leave out is
// asked in double, also with margins. So the answer is a list of spheres that is certain to contain
// the right one. Nearly always it has at most one sphere. If it has more, the caller decides with
// chapter 05's functions.
#ifndef CHAPTERS_08_FAST_ENGINES_ANY_RAY_H
#define CHAPTERS_08_FAST_ENGINES_ANY_RAY_H

#include "chapters/08-fast/engines/lanes.h"
#include "chapters/08-fast/engines/wide_hierarchy.h"

#include <math.h>
#include <stdbool.h>

// A ray whose direction has length 1: t is a distance.
typedef struct {
    double origin[3], direction[3];
} Line;

// Places in the order of the hierarchy. More than MOST_CANDIDATES: the list is not complete.
enum { MOST_CANDIDATES = 16 };
typedef struct {
    int count;
    int places[MOST_CANDIDATES];
} PossibleHits;

// The spheres that may be the nearest hit; none if the ray certainly misses all.
typedef void NearestOf(const RayWorld *world, const Line *line, PossibleHits *candidates);
extern NearestOf nearest_of_baseline, nearest_of_avx2, nearest_of_avx512;

// For each of many rays, the place of the only sphere that may be the nearest hit; or NO_PLACE if
// the ray certainly misses all; or IN_DOUBT: then ask nearest_of. Many rays in turns are faster
// than one after the other: while one waits for memory, others compute. left: for each ray the
// place of the sphere that it leaves, or NO_PLACE. Usually the ray certainly misses this sphere,
// and does not ask it again.
enum { NO_PLACE = -1, IN_DOUBT = -2 };
typedef void NearestOfMany(const RayWorld *world, const Line *lines, const int *left, int count,
                           int *places);
extern NearestOfMany nearest_of_many_baseline, nearest_of_many_avx2, nearest_of_many_avx512;

// ---- where a line meets a sphere, in doubles, with margins for rounding -----------------------

// The margin for a number that is the difference of two: many times their rounding error.
#define MARGIN 1e-12

// A line may meet a sphere at begin or later; if end is finite, it certainly does, between begin
// and end.
typedef struct {
    double begin, end;
} Meeting;

static inline double larger(double a, double b)
{
    return a > b ? a : b;
}

// A sphere with its centre at (x, y, z) from the start of the line, and the radius r.
static inline Meeting meet(double x, double y, double z, double r, const Line *line)
{
    double rr = r * r;
    double along = x * line->direction[0] + y * line->direction[1] + z * line->direction[2];
    double pp = x * x + y * y + z * z, margin = MARGIN * (pp + rr), outside = pp - rr;
    double d = rr - pp + along * along, least = d - margin;
    if (d + margin < 0 || (along < 0 && outside > margin))
        return (Meeting){INFINITY, INFINITY};
    double longest = sqrt(larger(d + margin, 0)), shortest = sqrt(larger(least, 0));
    double slack = MARGIN * (fabs(along) + r);
    if (outside > margin && least >= 0 && along - longest - slack > 0)
        return (Meeting){along - longest - slack, along - shortest + slack};
    if (outside > margin)
        return (Meeting){larger(along - longest - slack, 0), INFINITY};
    if (outside < -margin && along + shortest - slack > 0)
        return (Meeting){along + shortest - slack, along + longest + slack};
    return (Meeting){0, INFINITY};
}

static inline void add_candidate(PossibleHits *candidates, int place)
{
    if (candidates->count < MOST_CANDIDATES)
        candidates->places[candidates->count] = place;
    candidates->count++;
}

#endif
