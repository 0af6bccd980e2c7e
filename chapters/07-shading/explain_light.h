// explain_light.h - the light that one pixel sees.
#ifndef CHAPTERS_07_SHADING_EXPLAIN_LIGHT_H
#define CHAPTERS_07_SHADING_EXPLAIN_LIGHT_H

#include "common/camera.h"
#include "common/ray.h"
#include "common/scene.h"

// Tells of the rays that mirrors send on, in a loop that students write: their archive has none.
typedef void TellMirrors(const Scene *scene, Ray ray, Hit hit, int depth);

// Prints the light that the ray of a pixel sees, term by term, with depth mirrors. tell_mirrors may
// be NULL.
void explain_light(const Scene *scene, Camera camera, Resolution screen, Pixel pixel, int depth,
                   TellMirrors *tell_mirrors);

#endif
