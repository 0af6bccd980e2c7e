// shadow_lanes.h - shadow rays, many at once: which go into their own surface, and which spheres
// hide their light.
//
// All decisions have margins for rounding. If rounding could matter, a surface is EDGE_ON, and a
// ray is needed; a sphere MAY_HIDE, and chapter 07's function decides.
#ifndef CHAPTERS_08_FAST_ENGINES_SHADOW_LANES_H
#define CHAPTERS_08_FAST_ENGINES_SHADOW_LANES_H

#include "chapters/08-fast/engines/light_steps.h"

// Rays to a light: where they start, and the way to the light, or the direction of a distant one.
typedef struct {
    Vectors start, way;
    alignas(64) double length[PATHS]; // of the ways
    int passes[PATHS];                // the sphere that the ray leaves and misses, or -1
    int count;
} ShadowRays;

// Spheres that some of these rays ask, each its own: ray[i] asks sphere i.
typedef struct {
    Vectors center;
    alignas(64) double radius[PATHS];
    int ray[PATHS], verdict[PATHS];
    int count;
} Occluders;

typedef enum { LETS_PASS, HIDES, MAY_HIDE } Verdict;

// A picture of the scene from a light, as numbers. Pixels in each direction are size; columns and
// rows of cells are columns.
typedef struct {
    double right[3], up[3], forward[3], across, size;
    int columns;
} ViewNumbers;

// Where a light is, from a surface. If it is certainly behind the surface, no ray is needed. If it
// is certainly in front of it, and the surface is the outside of its sphere, the ray misses this
// sphere.
typedef enum { EDGE_ON, BEHIND, BEFORE } Side;

typedef struct {
    // The sides of the surfaces on which a light is.
    void (*sides)(const Paths *paths, const Vectors *ways, bool has_end, int *sides);
    // The lengths of directions; and the directions with length 1, if not NULL.
    void (*units)(const Vectors *directions, int count, double *lengths, Vectors *units);
    // The view that shows the start of each ray, and the cell there; cell -1 if no view shows it.
    // There is one view, or six around the light: along x, -x, y, -y, z, -z.
    void (*cells)(const double light[3], const ViewNumbers *numbers, int view_count,
                  const ShadowRays *rays, int *views, int *cells);
    // Whether each sphere hides the light, which is at t = 1.
    void (*ask)(const ShadowRays *rays, Occluders *occluders);
    // The same if all rays ask one sphere. False: it lets all pass.
    bool (*all_ask)(const ShadowRays *rays, const double center[3], double radius, int *verdicts);
} ShadowLanes;

extern const ShadowLanes shadow_lanes_baseline, shadow_lanes_avx2, shadow_lanes_avx512;

#endif
