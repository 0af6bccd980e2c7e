// shadow_lanes.h - shadow rays, many at once: which go into their own surface, and which spheres
// hide their light. All decisions here have margins for rounding.
#ifndef CHAPTERS_08_FAST_ENGINES_SHADOW_LANES_H
#define CHAPTERS_08_FAST_ENGINES_SHADOW_LANES_H

#include "chapters/08-fast/engines/bins_lanes.h"
#include "chapters/08-fast/engines/light_steps.h"

// Rays to a light: where they start, and the way to the light, or the direction of a distant one.
typedef struct {
    Vectors start, way;
    alignas(64) double length[PATHS]; // of the ways
    int count;
} ShadowRays;

// A sphere that some of these rays ask, each its own: ray[i] asks sphere i.
typedef struct {
    Vectors center;
    alignas(64) double radius[PATHS];
    int ray[PATHS], verdict[PATHS];
    int count;
} Occluders;

typedef enum { LETS_PASS, HIDES, MAY_HIDE } Verdict;

typedef struct {
    // Whether surfaces certainly hide a light from themselves, because it is behind them: 1 or 0.
    void (*behind)(const Paths *paths, const Vectors *ways, bool has_end, int *behind);
    // The lengths of directions; and the directions with length 1, if not NULL.
    void (*units)(const Vectors *directions, int count, double *lengths, Vectors *units);
    // The cell in which each ray starts; -1 if the view does not show it.
    void (*cells)(const Eye *view, const double light[3], int columns, const ShadowRays *rays,
                  int *cells);
    // Whether each sphere hides the light, which is at t = 1.
    void (*ask)(const ShadowRays *rays, Occluders *occluders);
} ShadowLanes;

extern const ShadowLanes shadow_lanes_baseline, shadow_lanes_avx2, shadow_lanes_avx512;

#endif
