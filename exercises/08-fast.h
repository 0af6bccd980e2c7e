// 08-fast.h - exercise 08: where a sphere is on the screen.
//
// Object order needs to ask only the pixels that a sphere can cover.
// Scale: a world that is k times as large has the same rectangles. Tests use sizes from 1e-6 to
// 1e6.
// Tolerance: 1e-6 of a pixel. Tests have spheres with centers that are at least 1.05 radii
// ahead of the eye, or clearly in one of the other two cases.
#ifndef EXERCISES_08_FAST_H
#define EXERCISES_08_FAST_H

#include "common/camera.h"
#include "common/screen.h"
#include "common/sphere.h"

// Returns the smallest rectangle of the screen that contains the outline of the sphere, in screen
// points, cut off at the edges of the screen: left and right are 0 to width, top and bottom are 0
// to height. It is exact, not rounded to whole pixels. Let ahead be the distance from the eye to
// the sphere's center, measured along forward.
//
// If ahead is at most -radius, the whole sphere is behind the eye: {0, 0, 0, 0}.
//
// If ahead is more than that, but at most radius, the eye is inside the sphere or beside it, and
// the rectangle is the whole screen.
//
// If ahead is more than radius, the sphere has an outline. If its rectangle does not overlap the
// screen, the result is {0, 0, 0, 0}. The image plane does not cut anything off: a sphere between
// the eye and the plane is visible.
ScreenRectangle sphere_rectangle(Camera camera, Resolution screen, Sphere sphere);

#endif
