// camera.c - is this a camera, and if not, why?
#include "common/camera.h"

static bool is_unit(vec3 v)
{
    return fabs(vec3_length(v) - 1) <= CAMERA_TOLERANCE;
}

static bool are_perpendicular(vec3 v, vec3 w)
{
    return fabs(vec3_dot(v, w)) <= CAMERA_TOLERANCE;
}

CameraFault camera_check(Camera c)
{
    if (!vec3_is_finite(c.origin) || !vec3_is_finite(c.right) || !vec3_is_finite(c.up) ||
        !vec3_is_finite(c.forward) || !isfinite(c.distance) || !isfinite(c.width) ||
        !isfinite(c.height))
        return CAMERA_NOT_FINITE;
    if (!is_unit(c.right) || !is_unit(c.up) || !is_unit(c.forward))
        return CAMERA_NOT_UNIT;
    if (!are_perpendicular(c.right, c.up) || !are_perpendicular(c.up, c.forward) ||
        !are_perpendicular(c.forward, c.right))
        return CAMERA_NOT_PERPENDICULAR;
    if (c.distance <= 0)
        return CAMERA_NO_DISTANCE;
    if (c.width <= 0)
        return CAMERA_NO_WIDTH;
    if (c.height <= 0)
        return CAMERA_NO_HEIGHT;
    return CAMERA_OK;
}

const char *camera_fault_text(CameraFault fault)
{
    static const char *const texts[CAMERA_FAULTS] = {
        [CAMERA_OK] = "nothing is wrong with it",
        [CAMERA_NOT_FINITE] = "a number in it is infinite or not a number",
        [CAMERA_NOT_UNIT] = "right, up and forward must each have length 1",
        [CAMERA_NOT_PERPENDICULAR] = "right, up and forward must be at right angles",
        [CAMERA_NO_DISTANCE] = "the distance to the image plane must be positive",
        [CAMERA_NO_WIDTH] = "the width of the image plane must be positive",
        [CAMERA_NO_HEIGHT] = "the height of the image plane must be positive",
        [CAMERA_NO_DIRECTION] = "the eye and the point looked at are the same",
        [CAMERA_UP_ALONG_VIEW] = "up is zero, or along the direction of view",
        [CAMERA_NO_RECTANGLE] = "the corners are not those of a rectangle",
        [CAMERA_OFF_AXIS] = "the eye is not straight behind the middle of the rectangle",
    };
    // A student's answer may be any number at all.
    if ((int)fault < 0 || fault >= CAMERA_FAULTS)
        return "(no such reason)";
    return texts[fault];
}
