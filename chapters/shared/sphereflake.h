// sphereflake.h - the spheres of Eric Haines' 'balls', as lines of NFF.
#ifndef CHAPTERS_SHARED_SPHEREFLAKE_H
#define CHAPTERS_SHARED_SPHEREFLAKE_H

#include "common/vec3.h"

// Prints the spheres of one generation, the 0th being the sphere itself: each carries nine of a
// third of its radius. 'above' is a unit vector, away from what the sphere is carried by.
void sphereflake_print(int generation, vec3 center, vec3 above, double radius);

#endif
