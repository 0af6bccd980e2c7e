// shadow_lanes.h - shadow rays, many at once: which go into their own surface, and which spheres
// hide their light.
//
// All decisions have margins for rounding. If rounding could matter, a ray is needed, and the
// verdict is IN_DOUBT: then chapter 07's function decides.
#ifndef CHAPTERS_08_FAST_ENGINES_SHADOW_LANES_H
#define CHAPTERS_08_FAST_ENGINES_SHADOW_LANES_H

#include "chapters/08-fast/engines/light_steps.h"
#include "common/sphere.h"

#include <stdbool.h>

// Rays to a light: where they start, and the way to the light, or the direction of a distant one.
// Each has a sphere that it leaves and certainly misses, or NO_SPHERE; or it is NO_RAY, because the
// light is certainly behind the surface.
enum { NO_SPHERE = -1, NO_RAY = -2 };
typedef struct {
    const Vectors *start, *way;
    bool endless; // the light is distant
    int passes[PATHS];
    int count;
} ShadowRays;

// In this order, so that of two verdicts the larger one counts.
typedef enum { ARRIVES, DOUBTFUL, HIDDEN } Verdict;

// The scene as a light sees it: one picture, or six around the light along x, -x, y, -y, z, -z.
// Each has columns x columns cells. Cell number c shows the spheres from start[c] to start[c + 1] -
// 1, near ones first, each with its least distance from the light. The last one can be NOT_LISTED:
// there are more.
enum { NOT_LISTED = -3 };
typedef struct {
    float near;
    int sphere;
} Shown;
typedef struct {
    int pictures, columns;
    bool parallel; // a distant light
    // Where the light is, or a place in the plane where parallel rays end, before all spheres; the
    // directions of a single picture; and how far rays at its edges go aside for each step ahead,
    // or how far parallel ones are from the middle.
    double light[3], right[3], up[3], forward[3], slope;
    Shown *shown;
    uint32_t *start;
} LightCells;

typedef struct {
    // Sets the spheres that rays to the light miss, or NO_RAY.
    void (*passes)(const Paths *paths, ShadowRays *rays);
    // The lengths of directions; and the directions with length 1, if not NULL.
    void (*units)(const Vectors *directions, int count, double *lengths, Vectors *units);
    // All rays ask one sphere of the scene whether it hides the light: at t = 1, or distant.
    void (*ask_one)(const ShadowRays *rays, const Sphere *spheres, int sphere, int *verdicts);
    // The rays that are not hidden yet ask the spheres in their cells.
    void (*ask_cells)(const ShadowRays *rays, const Sphere *spheres, const LightCells *cells,
                      int *verdicts);
} ShadowLanes;

extern const ShadowLanes shadow_lanes_baseline, shadow_lanes_avx2, shadow_lanes_avx512;

#endif
