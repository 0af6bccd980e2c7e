// sphere.h - the only shape in the world of this deck.
#ifndef COMMON_SPHERE_H
#define COMMON_SPHERE_H

#include "common/vec3.h"

typedef struct {
    vec3 center;
    double radius; // > 0
    int surface;   // index into the scene's surfaces, which have the colors
} Sphere;

#endif
