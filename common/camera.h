// camera.h - the camera <p, r, u, f, d, w, h> of the slide 'Camera', and other ways to give one.
//
// An eye, a frame of three directions, and a rectangle (the image plane) straight ahead.
// Whether numbers are a camera is decided here, with the reason; turning the other
// descriptions into a camera is exercise 02.
#ifndef COMMON_CAMERA_H
#define COMMON_CAMERA_H

#include "common/vec3.h"

typedef struct {
    vec3 origin;     // p, the eye
    vec3 right;      // r, unit
    vec3 up;         // u, unit, at right angles to r
    vec3 forward;    // f, unit, at right angles to both; either handedness
    double distance; // d > 0, from the eye to the middle of the image plane, along f
    double width;    // w > 0, of the image plane, in the world's units
    double height;   // h > 0
} Camera;

// The handedness of the world. Thumb to the right, first finger up: the middle finger of the right
// hand points back at you, that of the left hand forward.
//   right-handed  right = forward x up   NFF scenes, OpenGL, the course's code
//   left-handed   right = up x forward   the deck's drawings, POV-Ray, pbrt
typedef enum { RIGHT_HANDED, LEFT_HANDED } Handedness;

// The look-at of the slide 'Other camera representations'. The image plane passes through at.
typedef struct {
    vec3 eye;
    vec3 at;       // the point looked at, in the middle of the picture
    vec3 up;       // roughly up: any length but 0, not along the view
    double width;  // of the image plane, > 0
    double aspect; // width / height, > 0
} LookAt;

// The corners of the image plane: points of the world, or vectors from the eye.
typedef struct {
    vec3 upper_left, upper_right, lower_left, lower_right;
} Corners;

// Why something is not a camera. A negative value means that there is no answer.
typedef enum {
    CAMERA_OK,
    CAMERA_NOT_FINITE,
    CAMERA_NOT_UNIT,
    CAMERA_NOT_PERPENDICULAR,
    CAMERA_NO_DISTANCE,
    CAMERA_NO_WIDTH,
    CAMERA_NO_HEIGHT,
    CAMERA_NO_DIRECTION,
    CAMERA_UP_ALONG_VIEW,
    CAMERA_NO_RECTANGLE,
    CAMERA_OFF_AXIS,
    CAMERA_FAULTS // how many there are
} CameraFault;

// How far unit lengths and right angles may be off, as rounding leaves them.
#define CAMERA_TOLERANCE 1e-9

// CAMERA_OK, or the first of CAMERA_NOT_FINITE .. CAMERA_NO_HEIGHT that holds.
CameraFault camera_check(Camera camera);

// The reason in words, as the end of the sentence "this is not a camera: ...".
const char *camera_fault_text(CameraFault fault);

#endif
