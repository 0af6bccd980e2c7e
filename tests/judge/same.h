// same.h - do two answers agree? As near as rounding leaves two ways to compute the same thing.
//
// What a mistake computes is held against what a student returned: NaN agrees with NaN here, and
// no length or hand is free.
#ifndef TESTS_JUDGE_SAME_H
#define TESTS_JUDGE_SAME_H

#include "common/camera.h"
#include "common/image.h"
#include "common/ray.h"
#include "common/screen.h"
#include "exercises/05-quadratic.h"

#include <stdbool.h>

bool same_double(double a, double b);
bool same_vec3(vec3 a, vec3 b);
bool same_Camera(Camera a, Camera b);
bool same_CameraFault(CameraFault a, CameraFault b);
bool same_Normalized(Normalized a, Normalized b);
bool same_ScreenPoint(ScreenPoint a, ScreenPoint b);
bool same_Ray(Ray a, Ray b);
bool same_Quadratic(Quadratic a, Quadratic b);
bool same_Roots(Roots a, Roots b);
bool same_Hit(Hit a, Hit b);
bool same_Image(const Image *a, const Image *b);
bool same_doubles(const double *a, const double *b, const Image *image); // one per pixel

// From malloc; for what a mistake works on.
Image image_copy(const Image *image);
double *doubles_copy(const double *doubles, const Image *image);

#endif
