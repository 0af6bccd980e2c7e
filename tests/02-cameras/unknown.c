// unknown.c - wrong answers to exercise 02 that are not known mistakes.
#include "tests/proof/unknown.h"
#include "exercises/02-cameras.h"

// Checks whether the diagonals are equal, which is true of other quadrilaterals as well, and leaves
// the rest to camera_check.
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

// Refuses everything as not a rectangle.
static CameraFault behind_its_edge(vec3 eye, vec3 lower_left, vec3 across, vec3 up, Camera *camera)
{
    (void)eye;
    return camera_from_corner(lower_left + across, lower_left, across, up, camera);
}

static CameraFault forward_by_up_and_right(vec3 eye, Corners vectors, Camera *camera)
{
    CameraFault fault = camera_from_vectors(eye, vectors, camera);
    if (fault == CAMERA_OK)
        camera->forward = vec3_cross(camera->up, camera->right);
    return fault;
}

static CameraFault height_not_set(LookAt view, Handedness world, Camera *camera)
{
    double height = camera->height;
    CameraFault fault = camera_from_look_at(view, world, camera);
    camera->height = height;
    return fault;
}

static double radians_twice(double degrees, double distance)
{
    return width_from_angle(degrees * 3.14159265358979323846 / 180, distance);
}

// Looks for reasons in another order than the reference. That is allowed, and not a second mistake.
static CameraFault height_times_aspect(LookAt view, Handedness world, Camera *camera)
{
    vec3 ahead = view.at - view.eye, up = vec3_unit(view.up);
    double d = vec3_length(ahead);
    if (!vec3_is_finite(view.eye) || !vec3_is_finite(view.at) || !vec3_is_finite(view.up) ||
        !isfinite(view.width) || !isfinite(view.aspect))
        return CAMERA_NOT_FINITE;
    if (!(view.width > 0))
        return CAMERA_NO_WIDTH;
    if (!(view.aspect > 0))
        return CAMERA_NO_HEIGHT;
    if (d == 0)
        return CAMERA_NO_DIRECTION;
    vec3 f = ahead / d, r = world == RIGHT_HANDED ? vec3_cross(f, up) : vec3_cross(up, f);
    if (vec3_length(view.up) == 0 || vec3_length(r) <= CAMERA_TOLERANCE)
        return CAMERA_UP_ALONG_VIEW;
    r = vec3_unit(r);
    vec3 u = world == RIGHT_HANDED ? vec3_cross(r, f) : vec3_cross(f, r);
    *camera = (Camera){view.eye, r, u, f, d, view.width, view.width * view.aspect};
    return CAMERA_OK;
}

static const Unknown unknowns[] = {
    UNKNOWN(camera_from_look_at, height_times_aspect, "L10", "reasons in another order"),
    UNKNOWN(camera_from_vectors, by_diagonals,
            NOBODY " CAMERA_NOT_PERPENDICULAR is not a reason of this contract",
            "equal diagonals, and camera_check"),
    UNKNOWN(camera_from_corner, behind_its_edge, NOBODY " you refused it", "never a camera"),
    UNKNOWN(camera_from_vectors, forward_by_up_and_right, NOBODY, "f = u x r"),
    UNKNOWN(camera_from_look_at, height_not_set, NOBODY " height of *camera was never set",
            "height as it was"),
    UNKNOWN(width_from_angle, radians_twice, NOBODY, "degrees converted to radians twice"),
    {0},
};
OF_STEM(unknowns)
