// light_grid.h - the scene as a light sees it: which spheres may hide the light from a place?
//
// Shadow rays to a point light all end in one place. Backwards they are rays from an eye, so the
// bins of step 6 work for them: every cell of a grid in front of the light lists the spheres that
// it shows, near ones first. (Haines and Greenberg, 'The Light Buffer', 1986.) Rays to a distant
// light are parallel, and its grid is a plane before all spheres.
#ifndef CHAPTERS_08_FAST_ENGINES_LIGHT_GRID_H
#define CHAPTERS_08_FAST_ENGINES_LIGHT_GRID_H

#include "chapters/08-fast/engines/shadow_lanes.h"
#include "common/scene.h"

// The spheres of a scene without a few giants, if those are so large that the box around the others
// is much smaller: a ground, for example, or a sky. Every shadow ray asks the giants.
enum { MOST_GIANTS = 4 };
typedef struct {
    const Scene *scene;
    vec3 low, high; // corners of the box around the others
    int giant_count, giants[MOST_GIANTS];
} Crowd;
Crowd crowd_of(const Scene *scene);

// If the light is away from the crowd, one picture shows all of it. Otherwise there are six, the
// faces of a cube around the light; none if the numbers are extreme.
typedef struct {
    const Crowd *crowd;
    LightCells cells;
} LightGrid;

// The crowd must outlive the grid. False if there is not enough memory.
bool light_grid_build(LightGrid *grid, const Crowd *crowd, Light light);
void light_grid_free(LightGrid *grid);

// Whether the light arrives at the start of each ray: a Verdict for each. All are DOUBTFUL without
// a grid.
void light_grid_ask(const LightGrid *grid, const ShadowRays *rays, int *verdicts);

#endif
