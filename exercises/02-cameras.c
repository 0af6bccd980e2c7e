// 02-cameras.c - exercise 02: other ways to give a camera.
//
// Your answers go between BEGIN SOLUTION and END SOLUTION; helper functions may go anywhere.
// Questions and rules: exercises/02-cameras.h. The lesson: chapters/02-cameras/README.md.
// After each change:   make exercises EX=02
#include "exercises/02-cameras.h"

#include "common/answers.h"

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
    // When you have found a camera:  return give(found, camera);
    (void)give;
    return NOT_ANSWERED(CameraFault);
    // END SOLUTION
}

CameraFault camera_from_points(vec3 eye, Corners points, Camera *camera)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(CameraFault);
    // END SOLUTION
}

CameraFault camera_from_corner(vec3 eye, vec3 lower_left, vec3 across, vec3 up, Camera *camera)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(CameraFault);
    // END SOLUTION
}

CameraFault camera_from_look_at(LookAt view, Handedness world, Camera *camera)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(CameraFault);
    // END SOLUTION
}

double width_from_angle(double degrees, double distance)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(double);
    // END SOLUTION
}
