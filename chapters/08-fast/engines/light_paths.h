// light_paths.h - chapter 07's colour of a ray, with every search for a sphere made by a hierarchy.
//
// A ray needs few spheres: the one that it hits, and for each light one that hides it, if any. The
// wide hierarchy finds them. Chapter 07's shade then lights a scene of one sphere, with the lights
// that arrive there. A hidden light adds 0, so the numbers are the same, to the last digit.
#ifndef CHAPTERS_08_FAST_ENGINES_LIGHT_PATHS_H
#define CHAPTERS_08_FAST_ENGINES_LIGHT_PATHS_H

#include "chapters/08-fast/engines/any_ray.h"
#include "chapters/08-fast/engines/hierarchy.h"
#include "chapters/08-fast/engines/light_grid.h"
#include "common/ray.h"
#include "common/scene.h"

// A scene that rays from anywhere can ask.
typedef struct {
    const Scene *scene;
    Hierarchy hierarchy;
    RayWorld rays;
    Crowd crowd;
    LightGrid *grids; // of each light
} LightWorld;

// False if there is not enough memory.
bool light_world_build(LightWorld *world, const Scene *scene, int threads);
void light_world_free(LightWorld *world);

// Rays that are traced together.
enum { PATHS = 256 };

// Where a path is: its ray, what that hits, and where the next rays start.
typedef struct {
    Ray ray;
    Hit hit;
    vec3 normal, start;
    int last; // the mirrors it followed
} Path;

// The paths of one thread.
typedef struct {
    const LightWorld *world;
    int depth;
    Scene alone; // the scene, with one sphere and the lights that arrive
    Path *paths; // PATHS
    bool *lit;   // for each path, the lights that arrive
    // For each mirror and path: the colour there, and the part of it that the next one adds.
    Color *colors;
    double *parts;
    NearestOf *nearest;
    AnyBefore *before;
    NearestOfMany *nearest_of_many;
} LightPaths;

// False if there is not enough memory.
bool light_paths_begin(LightPaths *paths, const LightWorld *world, int depth);
void light_paths_end(LightPaths *paths);

// The colours that trace_ray finds in the scene for count rays, at most PATHS. spheres: the sphere
// that each ray hits, -1 for none; if NULL, it is searched.
void path_colors(LightPaths *paths, const Ray *rays, const int *spheres, int count, Color *colors);

#endif
