// 08-fast.h - exercise 08: where a sphere is on the screen.
//
// The first step of chapter 08: object order asks only the pixels that a sphere can cover.
// Scale: a world that is k times as large has the same rectangles. Tests use sizes from 1e-6 to
// 1e6. Tolerance: 1e-6 of a pixel. Tests have spheres with centres that are at least 1.05 radii
// ahead of the eye, or clearly in one of the other two cases.
#ifndef EXERCISES_08_FAST_H
#define EXERCISES_08_FAST_H

#include "common/camera.h"
#include "common/screen.h"
#include "common/sphere.h"

// The smallest rectangle of the screen that contains the outline of the sphere, in screen points,
// cut off at the edges of the screen: left and right are 0 to width, top and bottom are 0 to
// height. It is exact and not rounded to whole pixels. Let ahead be how far the sphere's centre is
// ahead of the eye, along forward:
// - if ahead is at most -radius, all of the sphere is behind the eye: {0, 0, 0, 0};
// - otherwise, if ahead is at most radius, the eye is inside the sphere or beside it, and the
// rectangle
//   is the whole screen;
// - otherwise the sphere has an outline. If its rectangle does not overlap the screen: {0, 0, 0,
// 0}. The image plane does not cut anything off: a sphere between the eye and the plane is seen.
ScreenRectangle sphere_rectangle(Camera camera, Resolution screen, Sphere sphere);

#endif
