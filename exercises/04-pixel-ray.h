// 04-pixel-ray.h - exercise 04: the ray of a pixel.
//
// Slide 'Mapping from Pixel to Camera Ray'. Made of the answers of 03 and 01; nothing new.
// Scale: in a world that is k times as large the ray has the same direction. Tests use sizes from
// 1e-6 to 1e6, and screens of any shape: portrait, landscape, a single column or row.
// Tolerance: 1e-9 of the distance, width and height.
#ifndef EXERCISES_04_PIXEL_RAY_H
#define EXERCISES_04_PIXEL_RAY_H

#include "common/camera.h"
#include "common/ray.h"
#include "common/screen.h"

// "Given a pixel position on the screen, find the ray in the camera." From the eye through the
// pixel's centre. Its length is free; the reference ends on the image plane, at t = 1.
Ray pixel_ray(Camera camera, Resolution screen, Pixel pixel);

#endif
