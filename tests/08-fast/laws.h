// laws.h - the laws of exercise 08.
#ifndef TESTS_08_FAST_LAWS_H
#define TESTS_08_FAST_LAWS_H

#include "common/camera.h"
#include "common/screen.h"
#include "common/sphere.h"

void law_sphere_rectangle(ScreenRectangle yours, Camera camera, Resolution screen, Sphere sphere);

#endif
