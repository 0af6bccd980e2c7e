// any_ray.h - one ray, from anywhere, asks 16 boxes at once, and then the spheres in them 8 at
// once.
//
// The boxes are those of wide_hierarchy.h, in floats. The spheres are doubles. Both have margins
// for rounding, so the answer is a list of spheres that is certain to contain the right one. Nearly
// always it has one sphere. If it has more, chapter 05's functions decide.
#ifndef CHAPTERS_08_FAST_ENGINES_ANY_RAY_H
#define CHAPTERS_08_FAST_ENGINES_ANY_RAY_H

#include "chapters/08-fast/engines/lanes.h"
#include "chapters/08-fast/engines/wide_hierarchy.h"

#include <stdbool.h>

// The input of a file of lanes; it contains no vec3.
typedef struct {
    const WideNode *nodes; // the root is the first; NULL if there are no spheres
    const double *x, *y, *z,
        *r;       // spheres, in the order of the hierarchy, and ASKED more at the end
    double scale; // of the boxes, see wide_build
} RayWorld;

// Spheres asked at once; the arrays of a RayWorld are longer by these.
enum { ASKED = 8 };

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

// A sphere that the ray certainly hits at a distance less than reach: true, and it is the only
// candidate. If no sphere is certain: false, and those that the ray may hit before reach.
typedef bool AnyBefore(const RayWorld *world, const Line *line, double reach,
                       PossibleHits *candidates);
extern AnyBefore any_before_baseline, any_before_avx2, any_before_avx512;

#endif
