// light_grid.h - the scene as a point light sees it: which spheres may hide the light from a place?
//
// Shadow rays to a point light all end in one place. Backwards they are rays from an eye, so the
// bins of step 6 work for them: every cell of a grid in front of the light lists the spheres that
// it shows, near ones first. (Haines and Greenberg, 'The Light Buffer', 1986.)
#ifndef CHAPTERS_08_FAST_ENGINES_LIGHT_GRID_H
#define CHAPTERS_08_FAST_ENGINES_LIGHT_GRID_H

#include "chapters/08-fast/engines/bins_lanes.h"
#include "chapters/08-fast/engines/shadow_lanes.h"
#include "common/ray.h"
#include "common/scene.h"

// One picture of the scene. A cell has 32 x 32 pixels, as a tile has. Cell number c has the spheres
// from start[c] to start[c + 1] - 1, near ones first, each with its least distance from the light.
typedef struct {
    float near;
    int sphere;
} Shown;
typedef struct {
    Eye eye;
    int columns; // of cells, and rows
    Shown *shown;
    uint32_t *start;
    ViewNumbers numbers;
} LightView;

// The spheres of a scene without a few giants, if those are so large that the box around the others
// is much smaller: a ground, for example, or a sky. Every shadow ray asks the giants.
enum { MOST_GIANTS = 4 };
typedef struct {
    const Scene *scene;
    vec3 low, high; // corners of the box around the others
    int giant_count, giants[MOST_GIANTS];
} Crowd;
Crowd crowd_of(const Scene *scene);

// If the light is away from the crowd, one view shows all of it. Otherwise there are six, the faces
// of a cube around the light.
typedef struct {
    const Crowd *crowd;
    vec3 light;
    int count; // of views; 0: no grid, because the light is distant or the numbers are extreme
    LightView views[6];
} LightGrid;

// The crowd must outlive the grid. False if there is not enough memory.
bool light_grid_build(LightGrid *grid, const Crowd *crowd, Light light, int threads);
void light_grid_free(LightGrid *grid);

// Whether a sphere hides a light, by chapter 07's function, in a world with only this sphere.
bool hides_light(const Sphere *sphere, vec3 from, const Light *light);

// Whether any sphere hides the light from the start of each ray. If rounding may decide, chapter
// 07's visibility does.
void light_grid_hides(const LightGrid *grid, const Light *light, const ShadowRays *rays,
                      bool *hidden);

#endif
