// 01-corners.h - exercise 01: from the eye to the image plane.
//
// Slides 'Camera' and 'Finding vectors from the eye to the image plane'. Begin with
// image_plane_vector: right or wrong, it draws three spheres (make watch EX=01).
// All answers are vectors from the eye to a point of the image plane, in the axes and units of the
// world. Their length is usually not 1. The frame of each camera is unit vectors at right angles;
// d, w and h are positive (camera.h).
// Scale: if the world is k times as large, the vector is k times as long. Tests use worlds from
// 1e-6 to 1e6, and planes that are wide, narrow, near and far. Tolerance: 1e-9 of the distance,
// width and height.
#ifndef EXERCISES_01_CORNERS_H
#define EXERCISES_01_CORNERS_H

#include "common/camera.h"
#include "common/vec3.h"

// "Give an expression for the upper left corner." Returns the vector from the eye to it.
vec3 upper_left(Camera c);

// "Give an expression for the upper right corner." Returns the vector from the eye to it.
vec3 upper_right(Camera c);

// "Give an expression for a point 30% of the way across the image plane and 10% up from the
// bottom." Returns the vector from the eye to it. Across is counted from the left edge.
vec3 across_30_up_10(Camera c);

// Returns the vector from the eye to any point: s of the way across from the left edge, t of the
// way up from the bottom edge. On the plane, s and t are 0 to 1; the same formula is right outside
// it.
vec3 image_plane_vector(Camera c, double s, double t);

// "Would it matter if d, w, h were all doubled?" Returns the camera that has distance 1 and gives
// the same picture: the same origin and frame, with another width and height.
Camera with_unit_distance(Camera c);

#endif
