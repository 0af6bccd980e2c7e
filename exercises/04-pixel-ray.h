// 04-pixel-ray.h - exercise 04: the ray of a pixel.
//
// Slide 'Mapping from Pixel to Camera Ray'. The answer calls your answers of 03 and 01; nothing new
// is computed.
// Scale: if the world is k times as large, the ray has the same direction. Tests use worlds from
// 1e-6 to 1e6, and screens of any shape: portrait, landscape, a single column or row.
// Tolerance: 1e-9 of the distance, width and height.
#ifndef EXERCISES_04_PIXEL_RAY_H
#define EXERCISES_04_PIXEL_RAY_H

#include "common/camera.h"
#include "common/ray.h"
#include "common/screen.h"

// "Given a pixel position on the screen, find the ray in the camera." Returns the ray from the eye
// through the center of the pixel. Its direction may have any length except 0. In the reference
// answer, the direction ends on the image plane, so t = 1 is there.
Ray pixel_ray(Camera camera, Resolution screen, Pixel pixel);

#endif
