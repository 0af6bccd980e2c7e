// camera-written-beyond: writes before and behind the camera that it was given to fill.
// stem: 02-cameras
// expect: graded | crashed
// earns: nothing
#include "exercises/02-cameras.h"

#include <string.h>

CameraFault camera_from_vectors(vec3 eye, Corners vectors, Camera *camera)
{
    memset((char *)camera - 4096, 0, 12288);
    return CAMERA_OK;
}

CameraFault camera_from_points(vec3 eye, Corners points, Camera *camera)
{
    return (CameraFault)0x7fffffff;
}
