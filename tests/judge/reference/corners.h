// corners.h - the corners of the image plane, by the reference.
#ifndef TESTS_JUDGE_REFERENCE_CORNERS_H
#define TESTS_JUDGE_REFERENCE_CORNERS_H

#include "common/camera.h"

// From the eye to the upper left, upper right, lower right and lower left one.
void reference_corners(Camera camera, vec3 corners[4]);

#endif
