// cast_spheres.h - which sphere each pixel of a picture shows, according to the linked answers, and
// in which order they set the pixels.
#ifndef CHAPTERS_06_RAY_CASTING_CAST_SPHERES_H
#define CHAPTERS_06_RAY_CASTING_CAST_SPHERES_H

#include "chapters/shared/needed_answers.h"
#include "common/camera.h"
#include "common/scene.h"
#include "common/screen.h"

#include <stdbool.h>

// Casts the scene in image order with a color of its own for each sphere, and reads the colors as
// numbers: spheres[row * width + column] is the index of the sphere, or -1. False if there is not
// enough memory.
bool cast_spheres(const Scene *scene, Camera camera, Resolution size, int *spheres);

// A pixel that was set to the color of a sphere, or to the background (-1).
typedef struct {
    Pixel pixel;
    int sphere;
} PixelSet;

// Casts the scene in one of the two orders, and lists the pixels as the answers set them; of a
// pixel that is set several times, each time. At most room are kept. Returns how many there were,
// or -1 if there is not enough memory.
int cast_pixel_sets(const Scene *scene, Camera camera, Resolution size, Order order, PixelSet *sets,
                    int room);

#endif
