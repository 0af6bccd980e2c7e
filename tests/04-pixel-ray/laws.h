// laws.h - the laws of exercise 04.
#ifndef TESTS_04_PIXEL_RAY_LAWS_H
#define TESTS_04_PIXEL_RAY_LAWS_H

#include "common/camera.h"
#include "common/ray.h"
#include "common/screen.h"

void law_pixel_ray(Ray yours, Camera camera, Resolution screen, Pixel pixel);

#endif
