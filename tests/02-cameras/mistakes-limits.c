// mistakes-limits.c - right in part: cameras that are refused, or accepted, by a limit that the
// author added, or because a length is compared with a fixed number instead of another length; and
// slips in one of two sizes.
#include "tests/02-cameras/mistakes.h"

static const double tiny = 1e-6;

// ---- rectangles ---------------------------------------------------------------------------------

static CameraFault small_planes_refused(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    CameraFault fault = reason(eye, v);
    if (fault == CAMERA_OK && c.distance < tiny)
        fault = CAMERA_NO_DISTANCE;
    else if (fault == CAMERA_OK && (c.width < tiny || c.height < tiny))
        fault = c.width < tiny ? CAMERA_NO_WIDTH : CAMERA_NO_HEIGHT;
    return store(fault, c, camera);
}

static vec3 gap_between_the_edges(Corners v)
{
    return v.upper_right - v.upper_left - (v.lower_right - v.lower_left);
}

// Right, except for how the gap is compared with CAMERA_TOLERANCE.
static CameraFault gap_as_a_length(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    CameraFault fault = reason(eye, v);
    bool gapes = is_off(vec3_length(gap_between_the_edges(v)));
    if (fault == CAMERA_OK && gapes)
        fault = CAMERA_NO_RECTANGLE;
    if (fault == CAMERA_NO_RECTANGLE && !gapes && !is_off(vec3_dot(c.right, c.up)))
        fault = reason_but(CAMERA_NO_RECTANGLE, eye, v);
    return store(fault, c, camera);
}

static CameraFault edges_dotted_not_unit(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    CameraFault fault = reason(eye, v);
    bool leans = is_off(c.width * c.height * vec3_dot(c.right, c.up));
    if (fault == CAMERA_OK && leans)
        fault = CAMERA_NO_RECTANGLE;
    if (fault == CAMERA_NO_RECTANGLE && !leans && !is_off(gap_of(v)))
        fault = reason_but(CAMERA_NO_RECTANGLE, eye, v);
    return store(fault, c, camera);
}

static CameraFault small_points_refused(vec3 eye, Corners points, Camera *camera)
{
    return small_planes_refused(eye, moved(points, -eye), camera);
}

static CameraFault small_edges_refused(vec3 eye, vec3 corner, vec3 across, vec3 up, Camera *camera)
{
    return small_planes_refused(eye, spanned(corner - eye, across, up), camera);
}

// ---- one of two sizes ---------------------------------------------------------------------------

static CameraFault half_of_the_width(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.width /= 2;
    return store(reason(eye, v), c, camera);
}

static CameraFault half_of_the_height(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.height /= 2;
    return store(reason(eye, v), c, camera);
}

static CameraFault width_for_both(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.height = c.width;
    return store(reason(eye, v), c, camera);
}

static CameraFault right_not_unit(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.right *= c.width;
    return store(reason(eye, v), c, camera);
}

static CameraFault up_not_unit(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.up *= c.height;
    return store(reason(eye, v), c, camera);
}

// ---- look-at ------------------------------------------------------------------------------------

static CameraFault near_places_refused(LookAt view, Handedness world, Camera *camera)
{
    if (view_reason(view) == CAMERA_OK && vec3_length(view.at - view.eye) < tiny)
        return CAMERA_NO_DIRECTION;
    return camera_from_look_at(view, world, camera);
}

static CameraFault small_widths_refused(LookAt view, Handedness world, Camera *camera)
{
    if (view_reason(view) == CAMERA_OK && view.width < tiny)
        return CAMERA_NO_WIDTH;
    return camera_from_look_at(view, world, camera);
}

static CameraFault short_cross_products_refused(LookAt view, Handedness world, Camera *camera)
{
    vec3 sideways = vec3_cross(view.at - view.eye, view.up);
    if (view_reason(view) == CAMERA_OK && vec3_length(sideways) < tiny)
        return CAMERA_UP_ALONG_VIEW;
    return camera_from_look_at(view, world, camera);
}

// ---- width from angle ---------------------------------------------------------------------------

static double width_in_float(double degrees, double distance)
{
    return 2 * (float)distance * tanf((float)degrees / 2 * (float)PI / 180);
}

static double small_angles_as_arcs(double degrees, double distance)
{
    double angle = degrees * PI / 180;
    return degrees < 1 ? distance * angle : 2 * distance * tan(angle / 2);
}

#define SMALL_WORLDS                                                                               \
    "a length is not small in itself, only compared with another one: a whole world can be "       \
    "smaller than that."

const Mistake camera_limit_mistakes[] = {
    MISTAKE("V-tiny", camera_from_vectors, small_planes_refused, "refused if d, w or h < 1e-6",
            SMALL_WORLDS, "no picture of tiny worlds"),
    MISTAKE("V-gap", camera_from_vectors, gap_as_a_length, "gap between the edges > 1e-9",
            "how far the edges may differ depends on their length. In a large world rounding "
            "leaves more than that, and in a tiny one every shape passes.",
            "no picture of large worlds, and a wrong one of tiny ones"),
    MISTAKE("V-dot", camera_from_vectors, edges_dotted_not_unit,
            "|across . up| > 1e-9, with edges of any length",
            "a dot product grows with both lengths. Normalise the edges, or divide by the lengths: "
            "then only the angle is left.",
            "no picture of large worlds, and a wrong one of tiny ones"),
    MISTAKE(
        "V-half-w", camera_from_vectors, half_of_the_width, "w = |upper right - upper left| / 2",
        "the width goes from edge to edge. Your height already does.", "everything twice as wide"),
    MISTAKE(
        "V-half-h", camera_from_vectors, half_of_the_height, "h = |upper left - lower left| / 2",
        "the height goes from edge to edge. Your width already does.", "everything twice as high"),
    MISTAKE(
        "V-both", camera_from_vectors, width_for_both, "h = w",
        "the height of the plane is the length of the left edge, from upper left to lower left.",
        "right if the plane is a square; if not, squashed or stretched"),
    MISTAKE("V-unit-r", camera_from_vectors, right_not_unit, "r = upper right - upper left",
            "the frame gives only directions, so each of its vectors has length 1. Your up and "
            "forward have.",
            "everything squeezed, or no picture"),
    MISTAKE("V-unit-u", camera_from_vectors, up_not_unit, "u = upper left - lower left",
            "the frame gives only directions, so each of its vectors has length 1. Your right and "
            "forward have.",
            "everything squeezed, or no picture"),
    MISTAKE("F-tiny", camera_from_points, small_points_refused, "refused if d, w or h < 1e-6",
            SMALL_WORLDS, "no picture of tiny worlds"),
    MISTAKE("K-tiny", camera_from_corner, small_edges_refused, "refused if d, w or h < 1e-6",
            SMALL_WORLDS, "no picture of tiny worlds"),
    MISTAKE("L-tiny", camera_from_look_at, near_places_refused, "refused if |at - eye| < 1e-6",
            SMALL_WORLDS, "no picture of tiny worlds"),
    MISTAKE("L-w-tiny", camera_from_look_at, small_widths_refused, "refused if w < 1e-6",
            SMALL_WORLDS, "no picture of tiny worlds"),
    MISTAKE("L12-tiny", camera_from_look_at, short_cross_products_refused,
            "refused if |(at - eye) x up| < 1e-6",
            "a cross product is short if its vectors are short. Normalise them first, or divide by "
            "their lengths: then only the sine of the angle is left.",
            "no picture of tiny worlds, or if up is short"),
    MISTAKE("A-float", width_from_angle, width_in_float, "in float",
            "a float has 7 digits, and the width needs 9. Use double.", "no visible difference"),
    MISTAKE("A-small", width_from_angle, small_angles_as_arcs, "the arc if the angle is below 1",
            "for a small angle arc and tangent are nearly the same, but not to 9 digits. No angle "
            "needs a special case.",
            "no visible difference"),
    {0},
};
