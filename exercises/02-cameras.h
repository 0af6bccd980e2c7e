// 02-cameras.h - exercise 02: other ways to give a camera.
//
// Slide 'Other camera representations'. The first four functions store the camera
// <p, r, u, f, d, w, h> in *camera and return CAMERA_OK. If there is no camera, they return the
// reason (camera.h) and leave *camera as it was. The arguments can be any numbers, also NaN and
// infinity. If several reasons hold, you may return any of them.
// Scale: if the world is k times as large, eye, distance, width and height are k times as large,
// and the same cameras are refused. Tests use worlds from 1e-9 to 1e9. Tolerance: 1e-9 of each
// part; rays through the same place on the plane agree to 1e-12.
#ifndef EXERCISES_02_CAMERAS_H
#define EXERCISES_02_CAMERAS_H

#include "common/camera.h"
#include "common/vec3.h"

// "Eye and four vectors": the vectors go from the eye to the corners of the image plane.
// CAMERA_NO_RECTANGLE: they do not end at the corners of a rectangle.
// CAMERA_OFF_AXIS: the eye is not straight behind the middle of the rectangle.
// CAMERA_NO_DISTANCE, CAMERA_NO_WIDTH, CAMERA_NO_HEIGHT: the distance, width or height is 0.
// CAMERA_NOT_FINITE: a number is infinite or NaN.
// Edges are equal if they differ by at most CAMERA_TOLERANCE x (width + height); an angle is a
// right angle if the absolute value of its cosine is at most CAMERA_TOLERANCE. Do not refuse a
// camera because of rounding.
CameraFault camera_from_vectors(vec3 eye, Corners vectors, Camera *camera);

// "Eye and four points": the points are the corners of the image plane. The same reasons.
CameraFault camera_from_points(vec3 eye, Corners points, Camera *camera);

// "Eye, lower left corner, two vectors": the corner is a point. The vectors are the lower edge,
// from left to right, and the left edge, from bottom to top. The same reasons.
CameraFault camera_from_corner(vec3 eye, vec3 lower_left, vec3 across, vec3 up, Camera *camera);

// "Lookat: eye point, lookat point, up vector, width, aspect ratio." The image plane passes through
// the look-at point; height = width / aspect. world is the handedness of the world: it says on
// which side right is (camera.h).
// CAMERA_NO_DIRECTION: the look-at point is the eye.
// CAMERA_UP_ALONG_VIEW: up is zero, or along or against the view: the sine of the angle is at
// most CAMERA_TOLERANCE.
// CAMERA_NO_WIDTH: the width is not positive. CAMERA_NO_HEIGHT: the aspect ratio is not positive.
// CAMERA_NOT_FINITE: a number is infinite or NaN.
CameraFault camera_from_look_at(LookAt view, Handedness world, Camera *camera);

// Returns the width of an image plane at this distance. degrees is the angle at the eye between its
// left and its right edge, 0 to 180. NFF scenes give this angle.
double width_from_angle(double degrees, double distance);

#endif
