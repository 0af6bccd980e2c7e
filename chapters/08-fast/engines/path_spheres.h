// path_spheres.h - the few spheres that a ray's path meets, found by a hierarchy, for chapter 07 to
// light.
//
// The result of trace_ray depends on the sphere that each ray of a path hits, and for each light on
// one sphere that hides it. All other spheres could be missing. So those few become a scene, and
// trace_ray is called with it: the same functions, the same numbers.
#ifndef CHAPTERS_08_FAST_ENGINES_PATH_SPHERES_H
#define CHAPTERS_08_FAST_ENGINES_PATH_SPHERES_H

#include "chapters/08-fast/engines/hierarchy.h"
#include "chapters/shared/render.h"

typedef struct {
    const Hierarchy *hierarchy;
    const Scene *scene;
    Scene few;    // the scene, with only these spheres
    int *indices; // their indices in the scene, ascending, so that ties are decided as there
} Few;

// Makes room for the spheres that a ray may meet with depth mirrors. False if there is not enough
// memory.
bool few_begin(Few *few, const Hierarchy *hierarchy, const Scene *scene, int depth);
void few_end(Few *few);

// The colour that trace_ray finds in the scene; the world is a Few, begun for this depth or more.
Tracer trace_few;

#endif
