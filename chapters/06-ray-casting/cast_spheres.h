// cast_spheres.h - which sphere each pixel of a picture shows, according to the linked answers.
#ifndef CHAPTERS_06_RAY_CASTING_CAST_SPHERES_H
#define CHAPTERS_06_RAY_CASTING_CAST_SPHERES_H

#include "common/camera.h"
#include "common/scene.h"
#include "common/screen.h"

#include <stdbool.h>

// Casts the scene in image order with a colour of its own for each sphere, and reads the colours as
// numbers: spheres[row * width + column] is the index of the sphere, or -1. False if there is not
// enough memory.
bool cast_spheres(const Scene *scene, Camera camera, Resolution size, int *spheres);

#endif
