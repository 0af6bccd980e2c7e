// explain_light.h - the light that one pixel sees.
#ifndef CHAPTERS_07_SHADING_EXPLAIN_LIGHT_H
#define CHAPTERS_07_SHADING_EXPLAIN_LIGHT_H

#include "common/camera.h"
#include "common/scene.h"

// Prints the light that the ray of a pixel sees, term by term, with depth mirrors.
void explain_light(const Scene *scene, Camera camera, Resolution screen, Pixel pixel, int depth);

#endif
