// covered_pixels.h - which pixels a sphere can cover.
#ifndef CHAPTERS_08_FAST_ENGINES_COVERED_PIXELS_H
#define CHAPTERS_08_FAST_ENGINES_COVERED_PIXELS_H

#include "common/camera.h"
#include "common/screen.h"
#include "common/sphere.h"

// Columns left to right - 1, rows top to bottom - 1; empty if left >= right or top >= bottom.
typedef struct {
    int left, right, top, bottom;
} Rectangle;

// A vec3 as plain numbers, for files of lanes (lanes.h).
static inline void view_store(double numbers[3], vec3 v)
{
    for (int i = 0; i < 3; i++)
        numbers[i] = v[i];
}

// All pixels whose rays may hit the sphere: the rectangle of exercise 08, and one more pixel on
// each side, so that rounding leaves none out.
Rectangle view_rectangle(Camera camera, Resolution screen, Sphere sphere);

#endif
