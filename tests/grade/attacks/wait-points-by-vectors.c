// wait-points-by-vectors: all forms by the first one, which is a placeholder.
// stem: 02-cameras
// expect: graded
// earns: nothing
#include "exercises/02-cameras.h"

CameraFault camera_from_vectors(vec3 eye, Corners vectors, Camera *camera)
{
    camera->origin = eye;
    camera->up = vectors.upper_left;
    return CAMERA_OK;
}

CameraFault camera_from_points(vec3 eye, Corners points, Camera *camera)
{
    points.upper_left -= eye;
    points.upper_right -= eye;
    points.lower_left -= eye;
    points.lower_right -= eye;
    return camera_from_vectors(eye, points, camera);
}

CameraFault camera_from_corner(vec3 eye, vec3 lower_left, vec3 across, vec3 up, Camera *camera)
{
    Corners c = {lower_left + up, lower_left + across + up, lower_left, lower_left + across};
    return camera_from_points(eye, c, camera);
}
