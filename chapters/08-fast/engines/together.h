// together.h - up to 16 rays from anywhere, walking through the hierarchy together.
//
// Rays that start at neighbouring pixels often ask the same boxes. A box is asked by all 16 in
// floats, a sphere by all 16 in doubles, with margins for rounding as in any_ray.h. A ray whose
// answer is not certain is in doubt: it asks again alone.
#ifndef CHAPTERS_08_FAST_ENGINES_TOGETHER_H
#define CHAPTERS_08_FAST_ENGINES_TOGETHER_H

#include "chapters/08-fast/engines/any_ray.h"
#include "chapters/08-fast/engines/hierarchy.h"
#include "chapters/08-fast/engines/lanes.h"

// Rays whose directions have length 1. Those from number count on are not asked.
typedef struct {
    double x[LANES], y[LANES], z[LANES];    // where they start
    double dx[LANES], dy[LANES], dz[LANES]; // their directions
    double reach[LANES];                    // hits farther away do not count
    int count;
} Lines;

// The answers, as bits: one for each ray.
typedef struct {
    unsigned hit, doubt;
    int places[LANES]; // of the nearest spheres, in the order of the hierarchy
} Answers;

// Which rays hit anything before their reach.
typedef void AnyOfLines(const RayWorld *world, const Node *nodes, const Lines *lines,
                        Answers *answers);
extern AnyOfLines any_of_lines_baseline, any_of_lines_avx2, any_of_lines_avx512;

// What each ray hits first; their reach is infinite.
typedef void NearestOfLines(const RayWorld *world, const Node *nodes, const Lines *lines,
                            Answers *answers);
extern NearestOfLines nearest_of_lines_baseline, nearest_of_lines_avx2, nearest_of_lines_avx512;

#endif
