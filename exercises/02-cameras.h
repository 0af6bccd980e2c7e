// 02-cameras.h - exercise 02: other ways to give a camera.
//
// Slide 'Other camera representations'. Each answer stores the camera <p, r, u, f, d, w, h> in
// *camera and returns CAMERA_OK; or it returns the reason why there is none (camera.h), and then
// *camera stays as it was. What goes in may be anything, NaN and infinity included; where several
// reasons hold, any of them is right.
// Scale: in a world that is k times as large eye, distance, width and height are k times as large,
// and what is refused is the same. Tests use sizes from 1e-9 to 1e9.
// Tolerance: 1e-9 of each part; rays through the same place of the plane agree to 1e-12.
#ifndef EXERCISES_02_CAMERAS_H
#define EXERCISES_02_CAMERAS_H

#include "common/camera.h"
#include "common/vec3.h"

// "Eye and four vectors": from the eye to the corners of the image plane.
// CAMERA_NO_RECTANGLE where they do not end in the corners of a rectangle, CAMERA_OFF_AXIS where
// the eye is not straight behind its middle; CAMERA_NO_DISTANCE, _WIDTH or _HEIGHT where one is 0;
// CAMERA_NOT_FINITE where a number is infinite or none. 'Is' means to CAMERA_TOLERANCE (camera.h)
// of the edges, and of 1 for a cosine: what rounding leaves is no reason to refuse.
CameraFault camera_from_vectors(vec3 eye, Corners vectors, Camera *camera);

// "Eye and four points": the corners themselves. The same reasons.
CameraFault camera_from_points(vec3 eye, Corners points, Camera *camera);

// "Eye, lower left corner, two vectors": the corner is a point, the vectors are the lower edge
// from left to right and the left edge from bottom to top. The same reasons.
CameraFault camera_from_corner(vec3 eye, vec3 lower_left, vec3 across, vec3 up, Camera *camera);

// "Lookat: eye point, lookat point, up vector, width, aspect ratio." The image plane passes
// through the point looked at; height = width / aspect. world says which hand the world has, and
// with it on which side right is (camera.h).
// CAMERA_NO_DIRECTION where at is the eye, CAMERA_UP_ALONG_VIEW where up is zero or along the
// view (to CAMERA_TOLERANCE), CAMERA_NOT_FINITE as above; CAMERA_NO_WIDTH where the width is not
// positive, CAMERA_NO_HEIGHT where the aspect is not.
CameraFault camera_from_look_at(LookAt view, Handedness world, Camera *camera);

// The width of an image plane that is seen under an angle (in degrees, 0 to 180, from its left edge
// to its right) from a distance in front of its middle. NFF scenes give the angle.
double width_from_angle(double degrees, double distance);

#endif
