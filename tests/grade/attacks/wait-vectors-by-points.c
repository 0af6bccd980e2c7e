// wait-vectors-by-points: the first of two forms by the second, which is a placeholder.
// stem: 02-cameras
// expect: graded
// earns: nothing
#include "exercises/02-cameras.h"

CameraFault camera_from_vectors(vec3 eye, Corners vectors, Camera *camera)
{
    vectors.upper_left += eye;
    vectors.upper_right += eye;
    vectors.lower_left += eye;
    vectors.lower_right += eye;
    return camera_from_points(eye, vectors, camera);
}

CameraFault camera_from_points(vec3 eye, Corners points, Camera *camera)
{
    camera->origin = points.upper_left;
    return CAMERA_OK;
}
