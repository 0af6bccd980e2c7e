// facts.c - what the laws of exercise 02 need to know: why arguments are no camera, as bits; first
// the reasons that hold without a doubt, then all that may be given, because rounding decides.
#include "exercises/02-cameras.h"

#include "tests/judge/known.h"

static int bit(CameraFault fault, bool holds)
{
    return holds ? 1 << fault : 0;
}

static double cosine(vec3 v, vec3 w)
{
    return fabs(vec3_dot(v, w)) / (vec3_length(v) * vec3_length(w)); // NaN if one is 0
}

// The reasons for four vectors: angles off by more than slack, lengths of at most tiny.
static int reasons_of(vec3 eye, Corners v, double slack, double tiny)
{
    vec3 top = v.upper_right - v.upper_left, bottom = v.lower_right - v.lower_left;
    vec3 left = v.upper_left - v.lower_left, right = v.upper_right - v.lower_right;
    vec3 middle = (v.upper_left + v.upper_right + v.lower_left + v.lower_right) / 4;
    vec3 normal = vec3_cross(top, left);
    bool finite = vec3_is_finite(top) && vec3_is_finite(bottom) && vec3_is_finite(middle);
    if (!finite || !vec3_is_finite(eye))
        return bit(CAMERA_NOT_FINITE, true) | bit(CAMERA_NO_RECTANGLE, !finite) |
               bit(CAMERA_OFF_AXIS, !finite);

    double gap = vec3_length(top - bottom) / (vec3_length(top) + vec3_length(left));
    bool no_middle = vec3_length(middle) <= tiny;
    bool no_width = fmin(vec3_length(top), vec3_length(bottom)) <= tiny;
    bool no_height = fmin(vec3_length(left), vec3_length(right)) <= tiny;
    bool beside = fabs(vec3_dot(middle, normal)) <= tiny * vec3_length(normal);
    return bit(CAMERA_NO_DISTANCE, no_middle || (beside && vec3_length(normal) > 0)) |
           bit(CAMERA_NO_WIDTH, no_width) | bit(CAMERA_NO_HEIGHT, no_height) |
           bit(CAMERA_NO_RECTANGLE,
               no_width || no_height || gap > slack || cosine(top, left) > slack) |
           bit(CAMERA_OFF_AXIS, no_middle ||
                                    fmax(cosine(top, middle), cosine(bottom, middle)) > slack ||
                                    fmax(cosine(left, middle), cosine(right, middle)) > slack);
}

static void reasons_of_rectangle(vec3 eye, Corners v)
{
    vec3 top = v.upper_right - v.upper_left, left = v.upper_left - v.lower_left;
    vec3 middle = (v.upper_left + v.upper_right + v.lower_left + v.lower_right) / 4;
    double far = vec3_length(top) + vec3_length(left) + vec3_length(middle) + vec3_length(eye);
    fact(reasons_of(eye, v, 1e-7, 0));
    fact(reasons_of(eye, v, 1e-10, 1e-7 * far));
}

FACTS(camera_from_vectors)
{
    reasons_of_rectangle(eye, vectors);
}

FACTS(camera_from_points)
{
    Corners vectors = {points.upper_left - eye, points.upper_right - eye, points.lower_left - eye,
                       points.lower_right - eye};
    reasons_of_rectangle(eye, vectors);
}

FACTS(camera_from_corner)
{
    vec3 corner = lower_left - eye;
    Corners vectors = {corner + up, corner + up + across, corner, corner + across};
    reasons_of_rectangle(eye, vectors);
}

// The reasons for a look-at: sines of at most slack between up and the view.
static int reasons_of_view(LookAt view, double slack)
{
    vec3 ahead = view.at - view.eye;
    double area = vec3_length(vec3_cross(ahead, view.up));
    bool no_width = !(view.width > 0) || isinf(view.width);
    bool no_height = !(view.width / view.aspect > 0);
    bool finite = vec3_is_finite(view.eye) && vec3_is_finite(ahead) && vec3_is_finite(view.up);
    bool no_direction = vec3_length(ahead) == 0;
    return bit(CAMERA_NOT_FINITE, !finite || !isfinite(view.width) || !isfinite(view.aspect)) |
           bit(CAMERA_NO_WIDTH, no_width) |
           bit(CAMERA_NO_HEIGHT, no_width || no_height || !(view.aspect > 0)) |
           bit(CAMERA_NO_DIRECTION, no_direction) |
           bit(CAMERA_UP_ALONG_VIEW,
               !no_direction && area <= slack * vec3_length(ahead) * vec3_length(view.up));
}

FACTS(camera_from_look_at)
{
    double distance = vec3_length(view.at - view.eye);
    int sure = reasons_of_view(view, 1e-12), may = reasons_of_view(view, 1e-6);
    if ((may >> CAMERA_UP_ALONG_VIEW & 1) == 1 && (sure >> CAMERA_UP_ALONG_VIEW & 1) == 0)
        may |= bit(CAMERA_NOT_PERPENDICULAR, true); // as large as rounding may leave it
    // Also true, though not the first reason one would give.
    may |= bit(CAMERA_NO_DISTANCE, distance == 0) |
           bit(CAMERA_NOT_FINITE, !isfinite(view.width / view.aspect));
    fact(sure);
    fact(may);
}
