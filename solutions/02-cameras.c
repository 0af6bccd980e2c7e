// 02-cameras.c - exercise 02: other ways to give a camera.
//
// Your answers go between BEGIN SOLUTION and END SOLUTION; helper functions may go anywhere.
// Questions and rules: exercises/02-cameras.h. The lesson: chapters/02-cameras/README.md.
// After each change:   make exercises EX=02
#include "exercises/02-cameras.h"

#include "common/answers.h"

// BEGIN SOLUTION
// Four points, and a corner with two vectors, become four vectors; four vectors become the frame.
// A look-at becomes the frame by cross products. Every camera is checked before it is stored.
// END SOLUTION

// Stores the camera and returns CAMERA_OK, or returns the reason why it is not a camera.
static CameraFault give(Camera found, Camera *camera)
{
    CameraFault fault = camera_check(found);
    if (fault == CAMERA_OK)
        *camera = found;
    return fault;
}

CameraFault camera_from_vectors(vec3 eye, Corners vectors, Camera *camera)
{
    // BEGIN SOLUTION
    //~ // When you have found a camera:  return give(found, camera);
    //~ (void)give;
    //~ return NOT_ANSWERED(CameraFault);
    vec3 across = vectors.upper_right - vectors.upper_left;
    vec3 upward = vectors.upper_left - vectors.lower_left;
    vec3 middle =
        (vectors.upper_left + vectors.upper_right + vectors.lower_left + vectors.lower_right) / 4;
    Camera found = {.origin = eye,
                    .right = vec3_unit(across),
                    .up = vec3_unit(upward),
                    .forward = vec3_unit(middle),
                    .distance = vec3_length(middle),
                    .width = vec3_length(across),
                    .height = vec3_length(upward)};
    if (!isfinite(found.distance) || !isfinite(found.width) || !isfinite(found.height))
        return CAMERA_NOT_FINITE;
    if (found.distance == 0)
        return CAMERA_NO_DISTANCE;
    if (found.width == 0)
        return CAMERA_NO_WIDTH;
    if (found.height == 0)
        return CAMERA_NO_HEIGHT;

    // In a rectangle, opposite edges are the same vector, and edges that meet are at right angles.
    vec3 gap = across - (vectors.lower_right - vectors.lower_left);
    if (vec3_length(gap) > CAMERA_TOLERANCE * (found.width + found.height) ||
        fabs(vec3_dot(found.right, found.up)) > CAMERA_TOLERANCE)
        return CAMERA_NO_RECTANGLE;
    if (fabs(vec3_dot(found.right, found.forward)) > CAMERA_TOLERANCE ||
        fabs(vec3_dot(found.up, found.forward)) > CAMERA_TOLERANCE)
        return CAMERA_OFF_AXIS;
    return give(found, camera);
    // END SOLUTION
}

CameraFault camera_from_points(vec3 eye, Corners points, Camera *camera)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(CameraFault);
    Corners vectors = {points.upper_left - eye, points.upper_right - eye, points.lower_left - eye,
                       points.lower_right - eye};
    return camera_from_vectors(eye, vectors, camera);
    // END SOLUTION
}

CameraFault camera_from_corner(vec3 eye, vec3 lower_left, vec3 across, vec3 up, Camera *camera)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(CameraFault);
    vec3 corner = lower_left - eye;
    Corners vectors = {corner + up, corner + across + up, corner, corner + across};
    return camera_from_vectors(eye, vectors, camera);
    // END SOLUTION
}

CameraFault camera_from_look_at(LookAt view, Handedness world, Camera *camera)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(CameraFault);
    vec3 ahead = view.at - view.eye;
    double distance = vec3_length(ahead);
    double up_length = vec3_length(view.up);
    if (!isfinite(distance) || !isfinite(up_length))
        return CAMERA_NOT_FINITE;
    if (distance == 0)
        return CAMERA_NO_DIRECTION;
    if (view.aspect <= 0)
        return CAMERA_NO_HEIGHT;

    vec3 forward = ahead / distance;
    vec3 sideways =
        world == RIGHT_HANDED ? vec3_cross(forward, view.up) : vec3_cross(view.up, forward);
    if (vec3_length(sideways) <= CAMERA_TOLERANCE * up_length)
        return CAMERA_UP_ALONG_VIEW;
    vec3 right = vec3_unit(sideways);
    // If up is almost along the view, rounding errors make right lean; make it perpendicular again.
    right = vec3_unit(right - vec3_dot(right, forward) * forward);
    vec3 up = world == RIGHT_HANDED ? vec3_cross(right, forward) : vec3_cross(forward, right);
    Camera found = {.origin = view.eye,
                    .right = right,
                    .up = up,
                    .forward = forward,
                    .distance = distance,
                    .width = view.width,
                    .height = view.width / view.aspect};
    return give(found, camera);
    // END SOLUTION
}

double width_from_angle(double degrees, double distance)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(double);
    return 2 * distance * tan(degrees / 2 * PI / 180);
    // END SOLUTION
}
