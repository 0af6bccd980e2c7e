// view.h - a sphere seen from the camera: in the camera's axes, and its rectangle on the screen.
#ifndef CHAPTERS_08_FAST_VIEW_H
#define CHAPTERS_08_FAST_VIEW_H

#include "common/camera.h"
#include "common/screen.h"
#include "common/sphere.h"

// Columns left to right - 1, rows top to bottom - 1; empty if left >= right or top >= bottom.
typedef struct {
    int left, right, top, bottom;
} Rectangle;

// The centre of a sphere by the camera's axes: right, up, forward, from the eye.
vec3 view_center(Camera camera, Sphere sphere);

// A vec3 as plain numbers, for files of lanes (lanes.h).
static inline void view_store(double numbers[3], vec3 v)
{
    for (int i = 0; i < 3; i++)
        numbers[i] = v[i];
}

// All pixels whose rays may hit the sphere: its exact rectangle on the screen, and one more pixel
// on each side, so that rounding leaves none out. If the eye is inside or beside the sphere, it is
// the whole screen.
Rectangle view_rectangle(Camera camera, Resolution screen, Sphere sphere);

#endif
