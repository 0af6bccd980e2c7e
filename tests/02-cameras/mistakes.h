// mistakes.h - what the wrong answers to exercise 02 share.
//
// Most are a right answer with one thing wrong, so a right answer comes first, in steps that can go
// wrong one by one: the numbers, never checked; the reason to refuse them; storing the result.
#ifndef TESTS_02_CAMERAS_MISTAKES_H
#define TESTS_02_CAMERAS_MISTAKES_H

#include "exercises/02-cameras.h"

#include "tests/judge/mistake.h"

extern const Mistake vector_mistakes[], vector_refusal_mistakes[], point_mistakes[],
    corner_mistakes[], look_at_mistakes[], look_at_refusal_mistakes[], vector_unchecked_mistakes[],
    look_at_unchecked_mistakes[], camera_limit_mistakes[];

// Without a check of the result.
static inline CameraFault store(CameraFault fault, Camera found, Camera *camera)
{
    if (fault == CAMERA_OK)
        *camera = found;
    return fault;
}

// As the blanks do: a camera in which camera_check finds a fault is refused as well.
static inline CameraFault give(CameraFault fault, Camera found, Camera *camera)
{
    return store(fault != CAMERA_OK ? fault : camera_check(found), found, camera);
}

// ---- rectangles -------------------------------------------------------------------------------

static inline Corners moved(Corners corners, vec3 by)
{
    return (Corners){corners.upper_left + by, corners.upper_right + by, corners.lower_left + by,
                     corners.lower_right + by};
}

// A rectangle from its lower left corner and two edges.
static inline Corners spanned(vec3 corner, vec3 across, vec3 up)
{
    return (Corners){corner + up, corner + up + across, corner, corner + across};
}

// The camera of four vectors, whatever they are.
static inline Camera frame(vec3 eye, Corners v)
{
    vec3 across = v.upper_right - v.upper_left, up = v.upper_left - v.lower_left;
    vec3 middle = (v.upper_left + v.upper_right + v.lower_left + v.lower_right) / 4;
    return (Camera){.origin = eye,
                    .right = vec3_unit(across),
                    .up = vec3_unit(up),
                    .forward = vec3_unit(middle),
                    .distance = vec3_length(middle),
                    .width = vec3_length(across),
                    .height = vec3_length(up)};
}

// The length that makes a gap: how far the lower edge differs from the upper, for its size.
static inline double gap_of(Corners v)
{
    vec3 across = v.upper_right - v.upper_left;
    double gap = vec3_length(across - (v.lower_right - v.lower_left));
    double size = vec3_length(across) + vec3_length(v.upper_left - v.lower_left);
    return size > 0 ? gap / size : gap;
}

// To the last bit: NaN and the remains of rounding are not 0.
static inline bool is_exact_rectangle(Corners v, Camera c)
{
    return gap_of(v) == 0 && vec3_dot(c.right, c.up) == 0;
}

static inline bool is_exactly_ahead(Camera c)
{
    return vec3_dot(c.right, c.forward) == 0 && vec3_dot(c.up, c.forward) == 0;
}

// NaN is not off: the checks for numbers that are not finite must find it.
static inline bool is_off(double x)
{
    return fabs(x) > CAMERA_TOLERANCE;
}

// One reason by itself.
static inline bool is_faulty(CameraFault fault, vec3 eye, Corners v)
{
    Camera c = frame(eye, v);
    switch (fault) {
    case CAMERA_NOT_FINITE:
        return !vec3_is_finite(eye) || !isfinite(c.distance) || !isfinite(gap_of(v)) ||
               !isfinite(c.width) || !isfinite(c.height);
    case CAMERA_NO_DISTANCE:
        return c.distance == 0;
    case CAMERA_NO_WIDTH:
        return c.width == 0;
    case CAMERA_NO_HEIGHT:
        return c.height == 0;
    case CAMERA_NO_RECTANGLE:
        return is_off(gap_of(v)) || is_off(vec3_dot(c.right, c.up));
    case CAMERA_OFF_AXIS:
        return is_off(vec3_dot(c.right, c.forward)) || is_off(vec3_dot(c.up, c.forward));
    default:
        return false;
    }
}

// The first reason, except for one that is forgotten (CAMERA_OK: none is).
static inline CameraFault reason_but(CameraFault forgotten, vec3 eye, Corners v)
{
    for (CameraFault fault = CAMERA_NOT_FINITE; fault < CAMERA_FAULTS; fault++)
        if (fault != forgotten && is_faulty(fault, eye, v))
            return fault;
    return CAMERA_OK;
}

static inline CameraFault reason(vec3 eye, Corners v)
{
    return reason_but(CAMERA_OK, eye, v);
}

static inline CameraFault forgetting(CameraFault forgotten, vec3 eye, Corners v, Camera *camera)
{
    return store(reason_but(forgotten, eye, v), frame(eye, v), camera);
}

// ---- look-at ----------------------------------------------------------------------------------

// The camera of a look-at, whatever it is.
static inline Camera seen(LookAt view, Handedness world)
{
    bool right_handed = world == RIGHT_HANDED;
    vec3 forward = vec3_unit(view.at - view.eye);
    vec3 sideways = right_handed ? vec3_cross(forward, view.up) : vec3_cross(view.up, forward);
    vec3 right = vec3_unit(sideways);
    return (Camera){.origin = view.eye,
                    .right = right,
                    .up = right_handed ? vec3_cross(right, forward) : vec3_cross(forward, right),
                    .forward = forward,
                    .distance = vec3_length(view.at - view.eye),
                    .width = view.width,
                    .height = view.width / view.aspect};
}

// The first reason, except for one that is forgotten (CAMERA_OK: none is).
static inline CameraFault view_reason_but(CameraFault forgotten, LookAt view)
{
    vec3 ahead = view.at - view.eye, sideways = vec3_cross(ahead, view.up);
    double length = vec3_length(ahead), up_length = vec3_length(view.up);
    if (forgotten != CAMERA_NOT_FINITE &&
        !(isfinite(length) && isfinite(up_length) && isfinite(view.width) && !isnan(view.aspect)))
        return CAMERA_NOT_FINITE;
    if (forgotten != CAMERA_NO_DIRECTION && length == 0)
        return CAMERA_NO_DIRECTION;
    if (forgotten != CAMERA_UP_ALONG_VIEW &&
        vec3_length(sideways) <= CAMERA_TOLERANCE * length * up_length)
        return CAMERA_UP_ALONG_VIEW;
    if (forgotten != CAMERA_NO_WIDTH && view.width <= 0)
        return CAMERA_NO_WIDTH;
    if (forgotten != CAMERA_NO_HEIGHT && (view.aspect <= 0 || isinf(view.aspect)))
        return CAMERA_NO_HEIGHT;
    return CAMERA_OK;
}

static inline CameraFault view_reason(LookAt view)
{
    return view_reason_but(CAMERA_OK, view);
}

#endif
