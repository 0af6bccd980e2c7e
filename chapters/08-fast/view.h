// view.h - the world as the camera sees it: a sphere in the camera's axes, and where it is on the
// screen.
#ifndef CHAPTERS_08_FAST_VIEW_H
#define CHAPTERS_08_FAST_VIEW_H

#include "common/camera.h"
#include "common/screen.h"
#include "common/sphere.h"

// Columns left to right - 1, rows top to bottom - 1; empty where left >= right or top >= bottom.
typedef struct {
    int left, right, top, bottom;
} Rectangle;

// The centre of a sphere by the camera's axes: right, up, forward, from the eye.
vec3 view_center(Camera camera, Sphere sphere);

// A vec3 as plain numbers, which is what files of lanes take (lanes.h).
static inline void view_store(double numbers[3], vec3 v)
{
    for (int i = 0; i < 3; i++)
        numbers[i] = v[i];
}

// All pixels whose rays may hit the sphere: its exact rectangle on the screen, and a pixel more on
// each side, so that rounding leaves none out. The whole screen where the eye is in or beside the
// sphere.
Rectangle view_rectangle(Camera camera, Resolution screen, Sphere sphere);

#endif
