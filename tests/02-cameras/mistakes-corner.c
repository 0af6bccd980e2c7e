// mistakes-corner.c - wrong answers to camera_from_corner_vectors: eye, lower left corner and two
// vectors.
#include "tests/02-cameras/mistakes.h"

static CameraFault taken_for_a_vector(vec3 eye, vec3 corner, vec3 across, vec3 up, Camera *camera)
{
    return camera_from_vectors(eye, spanned(corner, across, up), camera);
}

static CameraFault taken_for_the_upper_left(vec3 eye, vec3 corner, vec3 across, vec3 up,
                                            Camera *camera)
{
    return camera_from_points(eye, spanned(corner - up, across, up), camera);
}

static CameraFault taken_for_the_middle(vec3 eye, vec3 corner, vec3 across, vec3 up, Camera *camera)
{
    return camera_from_points(eye, spanned(corner - across / 2 - up / 2, across, up), camera);
}

static CameraFault across_and_up_swapped(vec3 eye, vec3 corner, vec3 across, vec3 up,
                                         Camera *camera)
{
    return camera_from_points(eye, spanned(corner, up, across), camera);
}

static CameraFault vectors_taken_for_corners(vec3 eye, vec3 corner, vec3 across, vec3 up,
                                             Camera *camera)
{
    return camera_from_points(eye, spanned(corner, across - corner, up - corner), camera);
}

static CameraFault edges_not_unit(vec3 eye, vec3 corner, vec3 across, vec3 up, Camera *camera)
{
    Corners v = spanned(corner - eye, across, up);
    Camera c = frame(eye, v);
    c.right = across;
    c.up = up;
    return give(reason(eye, v), c, camera);
}

// From forward and up, as in a look-at, and for one handedness.
static CameraFault right_worked_out(vec3 eye, vec3 corner, vec3 across, vec3 up, Camera *camera)
{
    Corners v = spanned(corner - eye, across, up);
    Camera c = frame(eye, v);
    c.right = vec3_cross(c.up, c.forward);
    return give(reason(eye, v), c, camera);
}

static CameraFault height_of_the_width(vec3 eye, vec3 corner, vec3 across, vec3 up, Camera *camera)
{
    Corners v = spanned(corner - eye, across, up);
    Camera c = frame(eye, v);
    c.height = c.width;
    return give(reason(eye, v), c, camera);
}

static CameraFault up_made_perpendicular(vec3 eye, vec3 corner, vec3 across, vec3 up,
                                         Camera *camera)
{
    Corners v = spanned(corner - eye, across, up);
    Camera c = frame(eye, v);
    c.up = vec3_unit(c.up - vec3_dot(c.up, c.right) * c.right);
    return give(reason_but(CAMERA_NO_RECTANGLE, eye, v), c, camera);
}

static CameraFault left_to_camera_check(vec3 eye, vec3 corner, vec3 across, vec3 up, Camera *camera)
{
    return give(CAMERA_OK, frame(eye, spanned(corner - eye, across, up)), camera);
}

static CameraFault nothing_refused(vec3 eye, vec3 corner, vec3 across, vec3 up, Camera *camera)
{
    return store(CAMERA_OK, frame(eye, spanned(corner - eye, across, up)), camera);
}

static CameraFault right_angle_not_checked(vec3 eye, vec3 corner, vec3 across, vec3 up,
                                           Camera *camera)
{
    return forgetting(CAMERA_NO_RECTANGLE, eye, spanned(corner - eye, across, up), camera);
}

static CameraFault axis_not_checked(vec3 eye, vec3 corner, vec3 across, vec3 up, Camera *camera)
{
    return forgetting(CAMERA_OFF_AXIS, eye, spanned(corner - eye, across, up), camera);
}

static CameraFault right_angle_compared_exactly(vec3 eye, vec3 corner, vec3 across, vec3 up,
                                                Camera *camera)
{
    Corners v = spanned(corner - eye, across, up);
    CameraFault fault = reason(eye, v);
    if (fault == CAMERA_OK && vec3_dot(across, up) != 0)
        fault = CAMERA_NO_RECTANGLE;
    return give(fault, frame(eye, v), camera);
}

static CameraFault axis_compared_exactly(vec3 eye, vec3 corner, vec3 across, vec3 up,
                                         Camera *camera)
{
    Corners v = spanned(corner - eye, across, up);
    Camera c = frame(eye, v);
    CameraFault fault = reason(eye, v);
    if (fault == CAMERA_OK && !is_exactly_ahead(c))
        fault = CAMERA_OFF_AXIS;
    return give(fault, c, camera);
}

// And NaN != 0 is true.
static CameraFault all_compared_exactly(vec3 eye, vec3 corner, vec3 across, vec3 up, Camera *camera)
{
    Corners v = spanned(corner - eye, across, up);
    Camera c = frame(eye, v);
    CameraFault fault = reason_but(CAMERA_NOT_FINITE, eye, v);
    if (fault == CAMERA_OK && vec3_dot(across, up) != 0)
        fault = CAMERA_NO_RECTANGLE;
    if (fault == CAMERA_OK && !is_exactly_ahead(c))
        fault = CAMERA_OFF_AXIS;
    return give(fault, c, camera);
}

static CameraFault stored_before_it_is_checked(vec3 eye, vec3 corner, vec3 across, vec3 up,
                                               Camera *camera)
{
    Corners v = spanned(corner - eye, across, up);
    *camera = frame(eye, v);
    return reason(eye, v);
}

const Mistake corner_mistakes[] = {
    MISTAKE("K-vector", camera_from_corner, taken_for_a_vector, "the lower left corner as a vector",
            "it is a point, counted from the origin, and the vectors of a camera start at the eye.",
            "no picture, unless the eye is at the origin: the camera is refused"),
    MISTAKE("K-upper", camera_from_corner, taken_for_the_upper_left,
            "upper left = the corner, lower left = the corner - up",
            "the given corner is a lower one, and up leads up from it.",
            "no picture: the plane is too low, and the camera is refused"),
    MISTAKE(
        "K-middle", camera_from_corner, taken_for_the_middle, "d f = the corner - p",
        "this leads to the lower left corner, but forward must lead to the middle of the plane.",
        "no picture: the plane is too low and too far left, and the camera is refused"),
    MISTAKE("K-swap", camera_from_corner, across_and_up_swapped, "w r = up, h u = across",
            "across is the lower edge, from left to right.", "transposed: rows become columns"),
    MISTAKE("K-corners", camera_from_corner, vectors_taken_for_corners,
            "w r = across - the corner, h u = up - the corner",
            "across and up are the edges themselves, not the corners where they end.",
            "no picture: every camera is refused"),
    MISTAKE("K-unit", camera_from_corner, edges_not_unit, "r = across, u = up",
            "the frame gives only directions, so each of its vectors has length 1. w and h hold "
            "the lengths.",
            "no picture: every camera is refused as not unit"),
    MISTAKE("K-hand", camera_from_corner, right_worked_out, "r = u x f",
            "this makes every frame left-handed. The lower edge says where right is, and the "
            "camera may have either handedness.",
            "every right-handed camera mirrored"),
    MISTAKE("K-square", camera_from_corner, height_of_the_width, "h = |across|",
            "this is the width. They are equal only if the plane is a square.",
            "stretched in height"),
    MISTAKE("K-straight", camera_from_corner, up_made_perpendicular,
            "up made perpendicular to across",
            "that is for the up of a look-at, which may lean. Here up is an edge of the plane, and "
            "an edge that leans does not make a rectangle.",
            "a picture, but its upper corners are not where you put them"),
    MISTAKE("K-check", camera_from_corner, left_to_camera_check, "only the checks of camera_check",
            "it sees only your frame, never the corner and the edges: it cannot know that the "
            "angle between them or their place is wrong.",
            "refused, but for another reason"),
    MISTAKE(
        "K-ok", camera_from_corner, nothing_refused, "CAMERA_OK, always",
        "any corner and two vectors make four corners, but not always a rectangle straight ahead.",
        "a skewed picture of corners that no camera has"),
    MISTAKE("K-lean", camera_from_corner, right_angle_not_checked, "any two vectors are accepted",
            "if they are not at right angles they span a parallelogram, and an image plane is a "
            "rectangle.",
            "sheared, as if through a leaning window"),
    MISTAKE("K-axis", camera_from_corner, axis_not_checked, "a rectangle anywhere is accepted",
            "f leads to its middle, but may not be perpendicular to it there.",
            "a skewed picture, as of a plane seen from the side"),
    MISTAKE("K-exact", camera_from_corner, right_angle_compared_exactly,
            "across . up == 0, exactly",
            "rounding leaves about 1e-17 instead of 0. CAMERA_TOLERANCE is how much rounding may "
            "leave.",
            "no picture if the numbers are not round: the camera is refused"),
    MISTAKE("K-exact-axis", camera_from_corner, axis_compared_exactly,
            "r . f == 0 and u . f == 0, exactly",
            "rounding leaves about 1e-17 instead of 0. CAMERA_TOLERANCE is how much rounding may "
            "leave.",
            "no picture if the numbers are not round: the camera is refused"),
    MISTAKE("K-exact-all", camera_from_corner, all_compared_exactly, "!= 0 in every comparison",
            "rounding leaves about 1e-17 instead of 0. CAMERA_TOLERANCE is how much rounding may "
            "leave.",
            "no picture if the numbers are not round: the camera is refused"),
    MISTAKE("K-store", camera_from_corner, stored_before_it_is_checked, "stored, then checked",
            "if the camera is refused, *camera must stay as it was, but this overwrites it.",
            "the previous camera is lost"),
    {0},
};
