// few.h - the few spheres that a ray's path meets, found by a hierarchy, for chapter 07 to light.
//
// What trace_ray says of a scene depends on the sphere that each ray of a path hits, and on whether
// some sphere hides each light. Every other sphere could as well not be there. So those few are
// made a scene of, and trace_ray is asked of that: the same functions, the same numbers.
#ifndef CHAPTERS_08_FAST_FEW_H
#define CHAPTERS_08_FAST_FEW_H

#include "chapters/08-fast/hierarchy.h"
#include "chapters/shared/render.h"

typedef struct {
    const Hierarchy *hierarchy;
    const Scene *scene;
    Scene few;    // the scene, but for its spheres
    int *indices; // what the few are in the scene, ascending: ties fall as they do there
} Few;

// Room for what a ray may meet through so many mirrors. False where memory is short.
bool few_begin(Few *few, const Hierarchy *hierarchy, const Scene *scene, int depth);
void few_end(Few *few);

// The colour that trace_ray finds in the scene; the world is a Few, begun for no less depth.
Tracer trace_few;

#endif
