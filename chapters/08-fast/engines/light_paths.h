// light_paths.h - chapter 07's colour of a ray, with every search for a sphere made by a hierarchy.
//
// A ray needs few spheres: the one that it hits, and for each light one that hides it, if any. The
// wide hierarchy finds them. Chapter 07's shade then lights a scene of one sphere, with the lights
// that arrive there. A hidden light adds 0, so the numbers are the same, to the last digit.
#ifndef CHAPTERS_08_FAST_ENGINES_LIGHT_PATHS_H
#define CHAPTERS_08_FAST_ENGINES_LIGHT_PATHS_H

#include "chapters/08-fast/engines/any_ray.h"
#include "chapters/08-fast/engines/hierarchy.h"
#include "chapters/shared/render.h"

// A scene that rays from anywhere can ask.
typedef struct {
    const Scene *scene;
    Hierarchy hierarchy;
    int *places; // of the spheres, in the order of the hierarchy
    WideNode *wide;
    double *numbers; // of the spheres, for rays
    RayWorld rays;
} LightWorld;

// False if there is not enough memory.
bool light_world_build(LightWorld *world, const Scene *scene, int threads);
void light_world_free(LightWorld *world);

// The paths of one thread.
typedef struct {
    const LightWorld *world;
    const int *seen; // the sphere that each sample sees, row by row, -1 for none; NULL: not known
    int columns;     // of samples
    Scene alone;     // the scene, with one sphere and the lights that arrive
    Sphere sphere;
    int *hiding; // for each light, the place of the last sphere that hid it: a good guess; or -1
    NearestOf *nearest;
    AnyBefore *before;
} LightPaths;

// False if there is not enough memory. seen may be NULL.
bool light_paths_begin(LightPaths *paths, const LightWorld *world, const int *seen, int columns);
void light_paths_end(LightPaths *paths);

// The colour that trace_ray finds in the scene; the world is a LightPaths.
Tracer trace_path;
Color path_color(LightPaths *paths, Ray ray, int depth);

#endif
