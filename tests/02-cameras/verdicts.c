// verdicts.c - wrong answers to exercise 02 that are not known mistakes, and the verdict on each.
#include "exercises/02-cameras.h"

#include "tests/judge/known.h"

// ---- rounding -----------------------------------------------------------------------------------

static bool differ(vec3 a, vec3 b)
{
    return a[0] != b[0] || a[1] != b[1] || a[2] != b[2];
}

#define REFUSES_ROUNDING NOBODY " you refuse rounding"

// Looks for reasons in another order than the reference. That is allowed, and not a second mistake.
UNNAMED(camera_from_look_at, "L10", "reasons in another order")
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

// Of vectors v that differ by rounding at most, if this holds.
#define REFUSES_IF(what, fault, holds)                                                             \
    UNNAMED(camera_from_vectors, REFUSES_ROUNDING, what)                                           \
    {                                                                                              \
        Corners v = vectors;                                                                       \
        return (holds) ? fault : camera_from_vectors(eye, v, camera);                              \
    }

REFUSES_IF("edges that are != each other", CAMERA_NO_RECTANGLE,
           differ(v.upper_right - v.upper_left, v.lower_right - v.lower_left))
REFUSES_IF("lengths of edges, by !=", CAMERA_NO_RECTANGLE,
           vec3_length(v.upper_right - v.upper_left) != vec3_length(v.lower_right - v.lower_left))
REFUSES_IF("diagonals, by !=", CAMERA_NO_RECTANGLE,
           vec3_length(v.upper_right - v.lower_left) != vec3_length(v.lower_right - v.upper_left))
REFUSES_IF("r . u != 0", CAMERA_NO_RECTANGLE,
           vec3_dot(vec3_unit(v.upper_right - v.upper_left),
                    vec3_unit(v.upper_left - v.lower_left)) != 0)
REFUSES_IF("gap above 1e-12", CAMERA_NO_RECTANGLE,
           vec3_length(v.upper_right - v.upper_left - (v.lower_right - v.lower_left)) > 1e-12)
REFUSES_IF("corner distances, by !=", CAMERA_OFF_AXIS,
           vec3_length(v.upper_left) != vec3_length(v.lower_right))
REFUSES_IF("dot above 1e-12", CAMERA_OFF_AXIS,
           fabs(vec3_dot(v.upper_left + v.upper_right + v.lower_left + v.lower_right,
                         v.upper_right - v.upper_left)) > 1e-12)

UNNAMED(camera_from_points, REFUSES_ROUNDING, "edges that are != each other")
{
    if (differ(points.upper_right - points.upper_left, points.lower_right - points.lower_left))
        return CAMERA_NO_RECTANGLE;
    return camera_from_points(eye, points, camera);
}

UNNAMED(camera_from_corner, REFUSES_ROUNDING, "across . up above 1e-12")
{
    if (fabs(vec3_dot(across, up)) > 1e-12)
        return CAMERA_NO_RECTANGLE;
    return camera_from_corner(eye, lower_left, across, up, camera);
}

UNNAMED(camera_from_look_at, NOBODY, "up == f or up == -f")
{
    vec3 f = vec3_unit(view.at - view.eye), up = vec3_unit(view.up);
    CameraFault fault = camera_from_look_at(view, world, camera);
    if (fault != CAMERA_UP_ALONG_VIEW || !differ(f, up) || !differ(f, -up))
        return fault;
    vec3 r = vec3_unit(vec3_cross(f, up)), u = vec3_cross(r, f);
    *camera = (Camera){
        view.eye, r, u, f, vec3_length(view.at - view.eye), view.width, view.width / view.aspect};
    return CAMERA_OK;
}

// Checks whether the diagonals are equal, which is true of other quadrilaterals as well, and leaves
// the rest to camera_check.
UNNAMED(camera_from_vectors, NOBODY " CAMERA_NOT_PERPENDICULAR is not a reason of this contract",
        "equal diagonals, and camera_check")
{
    Corners v = vectors;
    vec3 across = v.upper_right - v.upper_left, up = v.upper_left - v.lower_left;
    vec3 middle = (v.upper_left + v.upper_right + v.lower_left + v.lower_right) / 4;
    double one = vec3_length(v.upper_right - v.lower_left);
    double other = vec3_length(v.lower_right - v.upper_left);
    if (fabs(one - other) > 1e-9 * (one + other))
        return CAMERA_NO_RECTANGLE;
    double d = vec3_length(middle), w = vec3_length(across), h = vec3_length(up);
    if (d == 0 || w == 0 || h == 0)
        return d == 0 ? CAMERA_NO_DISTANCE : w == 0 ? CAMERA_NO_WIDTH : CAMERA_NO_HEIGHT;
    Camera found = {eye, across / w, up / h, middle / d, d, w, h};
    CameraFault fault = camera_check(found);
    if (fault == CAMERA_OK)
        *camera = found;
    return fault;
}

// Refuses everything as not a rectangle.
UNNAMED_LINE(camera_from_corner, NOBODY " you refused it", "never a camera",
             return camera_from_corner(lower_left + across, lower_left, across, up, camera))

UNNAMED(camera_from_vectors, NOBODY, "f = u x r")
{
    CameraFault fault = camera_from_vectors(eye, vectors, camera);
    if (fault == CAMERA_OK)
        camera->forward = vec3_cross(camera->up, camera->right);
    return fault;
}

UNNAMED(camera_from_look_at, NOBODY " height of *camera was never set", "height as it was")
{
    double height = camera->height;
    CameraFault fault = camera_from_look_at(view, world, camera);
    camera->height = height;
    return fault;
}

UNNAMED_LINE(width_from_angle, NOBODY, "degrees converted to radians twice",
             return width_from_angle(degrees * 3.14159265358979323846 / 180, distance))
