// support.h - what the tests and the probes of exercise 02 share.
#ifndef TESTS_02_CAMERAS_SUPPORT_H
#define TESTS_02_CAMERAS_SUPPORT_H

#include "exercises/01-corners.h"
#include "exercises/02-cameras.h"

#include "tests/judge/test.h"

#define TOLERANCE 1e-9

// ---- cameras ----------------------------------------------------------------------------------

// The camera of the tests of exercise 01, left-handed: no two numbers are equal, none is 0 or 1.
Camera oblique_camera(void);
// The same picture, mirrored: the other handedness.
Camera mirrored(Camera c);
// The value of *camera before the call, and still after a refusal.
Camera untouched(void);
// The deck's camera a few times, then others.
Camera camera_number(int i);
// The i-th of count cameras in worlds of any size, from 1e-9 to 1e9, and how large that world is.
Camera camera_of_any_size(int i, int count, double *size);
Normalized random_place(void);

// ---- what every answer must do ----------------------------------------------------------------

void expect_found(CameraFault fault, Camera found, Camera expected);
void expect_found_of_size(CameraFault fault, Camera found, Camera expected, double size);

// The rays through one place of the plane, and from the same eye: to twelve digits.
void expect_same_ray_through(Normalized place, CameraFault fault, Camera yours, Camera same);

// Reasons, a bit for each: if more than one is true, any of them may be given. A test lists first
// the one that it is about, since that is shown to a student who gives none; then those that are
// also true.
enum {
    FINITE = 1 << CAMERA_NOT_FINITE,
    DISTANCE = 1 << CAMERA_NO_DISTANCE,
    WIDTH = 1 << CAMERA_NO_WIDTH,
    HEIGHT = 1 << CAMERA_NO_HEIGHT,
    DIRECTION = 1 << CAMERA_NO_DIRECTION,
    UP = 1 << CAMERA_UP_ALONG_VIEW,
    RECTANGLE = 1 << CAMERA_NO_RECTANGLE,
    AXIS = 1 << CAMERA_OFF_AXIS,
};

CameraFault first_of(int reasons);
void expect_refused(CameraFault fault, Camera after, int reasons, int also);

// NaN, infinity, minus infinity.
double not_finite(int i);

// ---- the three that give a rectangle ----------------------------------------------------------

// VECTORS and POINTS: eye, upper left, upper right, lower left, lower right.
// CORNER: eye, lower left, across, up.
typedef enum { VECTORS, POINTS, CORNER } Form;

// Calls with these numbers.
void finds(Form form, const vec3 *in, Camera expected);
// Calls with random cameras of both handednesses, taken apart.
void finds_random_cameras(Form form);
void keeps_the_rays(Form form);
// Calls with each shape that is not a rectangle, or not straight ahead, and whose first reason is
// one of these.
void refuses(Form form, int reasons);
// Calls with the rectangles of random cameras, pushed out of shape or place.
void refuses_what_was_pushed(Form form);
// The laws of scale: calls with cameras in worlds of any size; and again with shapes that must be
// refused, in a tiny world and in an enormous one.
void finds_cameras_of_any_size(Form form);
void refuses_in_worlds_of_any_size(Form form);
// Calls with each number in turn not finite, and all others those of the deck's camera.
void refuses_what_is_not_finite(Form form);

#endif
