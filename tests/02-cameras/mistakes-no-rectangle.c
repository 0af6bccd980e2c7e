// mistakes-no-rectangle.c - wrong answers to eye and four vectors: which arguments are refused, and
// with which reason.
#include "tests/02-cameras/mistakes.h"

static CameraFault nothing_refused(vec3 eye, Corners v, Camera *camera)
{
    return store(CAMERA_OK, frame(eye, v), camera);
}

static CameraFault left_to_camera_check(vec3 eye, Corners v, Camera *camera)
{
    return give(CAMERA_OK, frame(eye, v), camera);
}

static CameraFault numbers_not_looked_at(vec3 eye, Corners v, Camera *camera)
{
    return forgetting(CAMERA_NOT_FINITE, eye, v, camera);
}

static CameraFault rectangle_not_checked(vec3 eye, Corners v, Camera *camera)
{
    return forgetting(CAMERA_NO_RECTANGLE, eye, v, camera);
}

static CameraFault right_angle_not_checked(vec3 eye, Corners v, Camera *camera)
{
    CameraFault fault = reason(eye, v);
    if (fault == CAMERA_NO_RECTANGLE && !is_off(gap_of(v)))
        fault = reason_but(CAMERA_NO_RECTANGLE, eye, v);
    return store(fault, frame(eye, v), camera);
}

static CameraFault fourth_corner_not_looked_at(vec3 eye, Corners v, Camera *camera)
{
    v.lower_right = v.lower_left + v.upper_right - v.upper_left;
    return give(reason(eye, v), frame(eye, v), camera);
}

static CameraFault only_lengths_compared(vec3 eye, Corners v, Camera *camera)
{
    double top = vec3_length(v.upper_right - v.upper_left);
    double bottom = vec3_length(v.lower_right - v.lower_left);
    double left = vec3_length(v.upper_left - v.lower_left);
    double right = vec3_length(v.upper_right - v.lower_right);
    double falling = vec3_length(v.lower_right - v.upper_left);
    double rising = vec3_length(v.upper_right - v.lower_left);
    CameraFault fault = reason(eye, v);
    double size = top + left;
    if (fault == CAMERA_NO_RECTANGLE && !is_off((top - bottom) / size) &&
        !is_off((left - right) / size) && !is_off((falling - rising) / size))
        fault = CAMERA_OK;
    return store(fault, frame(eye, v), camera);
}

static CameraFault axis_not_checked(vec3 eye, Corners v, Camera *camera)
{
    return forgetting(CAMERA_OFF_AXIS, eye, v, camera);
}

static CameraFault axis_checked_across_only(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    CameraFault fault = reason(eye, v);
    if (fault == CAMERA_OFF_AXIS && !is_off(vec3_dot(c.right, c.forward)))
        fault = CAMERA_OK;
    return store(fault, c, camera);
}

static CameraFault axis_checked_upward_only(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    CameraFault fault = reason(eye, v);
    if (fault == CAMERA_OFF_AXIS && !is_off(vec3_dot(c.up, c.forward)))
        fault = CAMERA_OK;
    return store(fault, c, camera);
}

static CameraFault one_percent_is_good_enough(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    CameraFault fault = reason(eye, v);
    if ((fault == CAMERA_NO_RECTANGLE || fault == CAMERA_OFF_AXIS) && gap_of(v) < 0.01 &&
        fabs(vec3_dot(c.right, c.up)) < 0.01 && fabs(vec3_dot(c.right, c.forward)) < 0.01 &&
        fabs(vec3_dot(c.up, c.forward)) < 0.01)
        fault = CAMERA_OK;
    return store(fault, c, camera);
}

static CameraFault compared_exactly(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    CameraFault fault = reason(eye, v);
    if (fault == CAMERA_OK && !is_exact_rectangle(v, c))
        fault = CAMERA_NO_RECTANGLE;
    return give(fault, c, camera);
}

static CameraFault axis_compared_exactly(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    CameraFault fault = reason(eye, v);
    if (fault == CAMERA_OK && !is_exactly_ahead(c))
        fault = CAMERA_OFF_AXIS;
    return give(fault, c, camera);
}

// And NaN != 0 is true.
static CameraFault all_compared_exactly(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    CameraFault fault = reason_but(CAMERA_NOT_FINITE, eye, v);
    if (fault == CAMERA_OK && !is_exact_rectangle(v, c))
        fault = CAMERA_NO_RECTANGLE;
    if (fault == CAMERA_OK && !is_exactly_ahead(c))
        fault = CAMERA_OFF_AXIS;
    return give(fault, c, camera);
}

static CameraFault no_distance_not_noticed(vec3 eye, Corners v, Camera *camera)
{
    return forgetting(CAMERA_NO_DISTANCE, eye, v, camera);
}

static CameraFault no_width_not_noticed(vec3 eye, Corners v, Camera *camera)
{
    return forgetting(CAMERA_NO_WIDTH, eye, v, camera);
}

static CameraFault no_height_not_noticed(vec3 eye, Corners v, Camera *camera)
{
    return forgetting(CAMERA_NO_HEIGHT, eye, v, camera);
}

static CameraFault one_reason_for_all(vec3 eye, Corners v, Camera *camera)
{
    CameraFault fault = reason(eye, v);
    return give(fault == CAMERA_OK ? CAMERA_OK : CAMERA_NO_RECTANGLE, frame(eye, v), camera);
}

static CameraFault stored_before_it_is_checked(vec3 eye, Corners v, Camera *camera)
{
    *camera = frame(eye, v);
    return reason(eye, v);
}

static CameraFault never_stored(vec3 eye, Corners v, Camera *camera)
{
    (void)camera;
    return reason(eye, v);
}

const Mistake vector_refusal_mistakes[] = {
    MISTAKE("V-ok", camera_from_vectors, nothing_refused, "CAMERA_OK, always",
            "any four vectors have a mean and edges, but their ends are not always the corners of "
            "a rectangle straight ahead.",
            "a skewed picture of four corners that no camera has"),
    MISTAKE("V-check", camera_from_vectors, left_to_camera_check, "only the checks of camera_check",
            "it sees only your frame, never the four corners: it cannot know that the fourth is "
            "wrong, nor that the shape or its place is wrong.",
            "some refused, but for another reason; some accepted"),
    MISTAKE("V-nan", camera_from_vectors, numbers_not_looked_at, "NaN and infinity are accepted",
            "every comparison with NaN is false, so a test for 'too big' does not catch it.",
            "a black picture: a number of the camera is NaN"),
    MISTAKE("V-any", camera_from_vectors, rectangle_not_checked, "any four corners are accepted",
            "a trapezoid or a parallelogram also has edges, but not the w and h of a camera.",
            "a picture, though no camera has these corners"),
    MISTAKE("V-lean", camera_from_vectors, right_angle_not_checked, "a parallelogram is accepted",
            "its opposite edges are equal, but they are not at right angles.",
            "sheared, as if through a leaning window"),
    MISTAKE("V-three", camera_from_vectors, fourth_corner_not_looked_at,
            "three corners, never the lower right",
            "three corners make a rectangle whatever the fourth is, so the fourth may be anywhere.",
            "a picture, though one corner is not where it should be"),
    MISTAKE("V-lengths", camera_from_vectors, only_lengths_compared,
            "edges and diagonals compared by length",
            "a saddle has equal edges and diagonals as well, and it is not even flat.",
            "a picture, though the corners are not in one plane"),
    MISTAKE("V-axis", camera_from_vectors, axis_not_checked, "a rectangle anywhere is accepted",
            "f leads to its middle, but may not be perpendicular to it there.",
            "a skewed picture, as of a plane seen from the side"),
    MISTAKE("V-axis-u", camera_from_vectors, axis_checked_across_only, "r . f checked, u . f not",
            "the rectangle may be too high or too low, or lean back.", "skewed from top to bottom"),
    MISTAKE("V-axis-r", camera_from_vectors, axis_checked_upward_only, "u . f checked, r . f not",
            "the rectangle may be too far left or right, or turned to the side.",
            "skewed from left to right"),
    MISTAKE("V-loose", camera_from_vectors, one_percent_is_good_enough, "right angles to 1%",
            "the contract allows only for rounding: one part in 1e9.",
            "hardly skewed, but the corners are not the given ones"),
    MISTAKE("V-exact", camera_from_vectors, compared_exactly,
            "upper edge == lower edge and r . u == 0, exactly",
            "rounding leaves about 1e-17 instead of 0. CAMERA_TOLERANCE is how much rounding may "
            "leave.",
            "no picture if the numbers are not round: the camera is refused"),
    MISTAKE("V-exact-axis", camera_from_vectors, axis_compared_exactly,
            "r . f == 0 and u . f == 0, exactly",
            "rounding leaves about 1e-17 instead of 0. CAMERA_TOLERANCE is how much rounding may "
            "leave.",
            "no picture if the numbers are not round: the camera is refused"),
    MISTAKE("V-exact-all", camera_from_vectors, all_compared_exactly, "!= 0 in every comparison",
            "rounding leaves about 1e-17 instead of 0. CAMERA_TOLERANCE is how much rounding may "
            "leave.",
            "no picture if the numbers are not round: the camera is refused"),
    MISTAKE("V-d", camera_from_vectors, no_distance_not_noticed, "d = 0 is not noticed",
            "an eye in the middle of its own image plane looks nowhere, and normalising (0, 0, 0) "
            "gives NaN.",
            "a black picture: forward is NaN"),
    MISTAKE("V-w", camera_from_vectors, no_width_not_noticed, "w = 0 is not noticed",
            "an edge of length 0 has no direction, and normalising it gives NaN.",
            "a black picture: right is NaN"),
    MISTAKE("V-h", camera_from_vectors, no_height_not_noticed, "h = 0 is not noticed",
            "an edge of length 0 has no direction, and normalising it gives NaN.",
            "a black picture: up is NaN"),
    MISTAKE("V-reason", camera_from_vectors, one_reason_for_all,
            "CAMERA_NO_RECTANGLE for every fault",
            "a rectangle that is only in the wrong place is still a rectangle, and the caller "
            "wants to know what to correct.",
            "refused, but for another reason"),
    MISTAKE("V-store", camera_from_vectors, stored_before_it_is_checked, "stored, then checked",
            "if the camera is refused, *camera must stay as it was, but this overwrites it.",
            "the previous camera is lost"),
    MISTAKE("V-never", camera_from_vectors, never_stored, "*camera never stored",
            "CAMERA_OK promises that *camera holds the camera.",
            "the picture of whatever camera was there before"),
    {0},
};
