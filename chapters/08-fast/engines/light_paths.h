// light_paths.h - chapter 07's colour of a ray, without asking every sphere.
//
// A ray needs few spheres: the one that it hits, and for each light one that hides it, if any. The
// wide hierarchy and the grids of the lights find them. light_steps.h computes the rest. A hidden
// light adds 0, so the numbers are the same, to the last digit.
#ifndef CHAPTERS_08_FAST_ENGINES_LIGHT_PATHS_H
#define CHAPTERS_08_FAST_ENGINES_LIGHT_PATHS_H

#include "chapters/08-fast/engines/any_ray.h"
#include "chapters/08-fast/engines/hierarchy.h"
#include "chapters/08-fast/engines/light_grid.h"
#include "chapters/08-fast/engines/light_steps.h"
#include "common/ray.h"
#include "common/scene.h"

// A scene that rays from anywhere can ask.
typedef struct {
    const Scene *scene;
    Hierarchy hierarchy;
    RayWorld rays;
    Crowd crowd;
    LightGrid *grids; // of each light
    Material *materials;
} LightWorld;

// False if there is not enough memory.
bool light_world_build(LightWorld *world, const Scene *scene, int threads);
void light_world_free(LightWorld *world);

// The paths of one thread.
typedef struct {
    const LightWorld *world;
    int depth;
    Picture picture;
    const LightSteps *steps; // steps_by_chapters, unless the caller sets others
    Paths *paths;            // and others that ask
    Vectors *directions;
    double *lit; // for each light and path: not 0 if the light arrives
    // For each mirror and path: the colour there, and the part of it that the next one adds. In the
    // end colors[0] are those of the paths.
    Vectors *colors;
    double *parts;
    // any_ray.h, for this processor.
    NearestOf *nearest;
    NearestOfMany *nearest_of_many;
} LightPaths;

// False if there is not enough memory.
bool light_paths_begin(LightPaths *paths, const LightWorld *world, int depth);
void light_paths_end(LightPaths *paths);

// Finds the colours that trace_ray finds in the scene for paths->count rays; set paths->origin and
// paths->direction, or let steps->rays set them. known: paths->sphere has the sphere that each ray
// hits. Otherwise they are searched.
void path_colors(LightPaths *paths, bool known);

#endif
