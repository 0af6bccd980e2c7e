// 02-cameras.c - wrong answers to exercise 02 that are no known mistake.
#include "exercises/02-cameras.h"
#include "tests/unknown/unknown.h"

// Asks whether the diagonals are equal, which they are in other quadrilaterals, too, and leaves the
// rest to camera_check.
static CameraFault by_diagonals(vec3 eye, Corners v, Camera *camera)
{
    vec3 across = v.upper_right - v.upper_left, up = v.upper_left - v.lower_left;
    double one = vec3_length(v.upper_right - v.lower_left);
    double other = vec3_length(v.lower_right - v.upper_left);
    vec3 middle = (v.upper_left + v.upper_right + v.lower_left + v.lower_right) / 4;
    if (fabs(one - other) > 1e-9 * (one + other))
        return CAMERA_NO_RECTANGLE;
    if (vec3_length(middle) == 0)
        return CAMERA_NO_DISTANCE;
    if (vec3_length(across) == 0)
        return CAMERA_NO_WIDTH;
    if (vec3_length(up) == 0)
        return CAMERA_NO_HEIGHT;
    Camera found = {eye,
                    vec3_unit(across),
                    vec3_unit(up),
                    vec3_unit(middle),
                    vec3_length(middle),
                    vec3_length(across),
                    vec3_length(up)};
    CameraFault fault = camera_check(found);
    if (fault == CAMERA_OK)
        *camera = found;
    return fault;
}

const Unknown unknowns[] = {
    UNKNOWN(camera_from_vectors, by_diagonals,
            NOBODY " CAMERA_NOT_PERPENDICULAR is not a reason of this contract",
            "equal diagonals, and camera_check"),
    {0},
};
