// 01-corners.h - exercise 01: from the eye to the image plane.
//
// Slides 'Camera' and 'Finding vectors from the eye to the image plane'. All answers are vectors
// from the eye, in the world's axes and units, not unit length: they end on the image plane.
// Cameras are cameras (camera.h): unit directions at right angles; d, w and h positive.
// Scale: in a world that is k times as large the vector is k times as long. Tests use sizes from
// 1e-6 to 1e6, wide and narrow planes, near and far.
// Tolerance: 1e-9 of the distance, width and height.
#ifndef EXERCISES_01_CORNERS_H
#define EXERCISES_01_CORNERS_H

#include "common/camera.h"
#include "common/vec3.h"

// "Give an expression for the upper left corner."
vec3 upper_left(Camera c);

// "Give an expression for the upper right corner."
vec3 upper_right(Camera c);

// "Give an expression for a point 30% of the way across the image plane and 10% up from the
// bottom." Across is counted from the left edge.
vec3 across_30_up_10(Camera c);

// The same for any point: s of the way across from the left edge, t of the way up from the
// bottom. The plane is 0..1 by 0..1; beyond it the formula just goes on.
vec3 image_plane_vector(Camera c, double s, double t);

// "Would it matter if d, w, h were all doubled?" The camera that gives the same picture with
// distance 1: the same origin and frame, and the width and height that go with it.
Camera with_unit_distance(Camera c);

#endif
