// mistakes-limits.c - right in part: cameras refused, or let through, by a limit of the author's
// own, lengths held against a fixed number and not against each other; and slips in one of two
// sizes.
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

// Right, but for how the gap is held against CAMERA_TOLERANCE.
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

// ---- one of two sizes
// -----------------------------------------------------------------------------

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
    "a length is not small in itself, only beside another one: there are worlds that are all "     \
    "smaller than that."

const Mistake camera_limit_mistakes[] = {
    MISTAKE("V-tiny", camera_from_vectors, small_planes_refused, "refused where d, w or h < 1e-6",
            SMALL_WORLDS, "no picture of tiny worlds"),
    MISTAKE("V-gap", camera_from_vectors, gap_as_a_length, "gap between the edges > 1e-9",
            "how far the edges may differ depends on how long they are. In a large world rounding "
            "leaves more than that, and in a tiny one every shape passes.",
            "no picture of large worlds, and a wrong one of tiny ones"),
    MISTAKE("V-dot", camera_from_vectors, edges_dotted_not_unit,
            "|across . up| > 1e-9, of edges as long as they are",
            "a dot product grows with both lengths. Make the edges unit, or divide by the lengths, "
            "and what is left is the angle.",
            "no picture of large worlds, and a wrong one of tiny ones"),
    MISTAKE("V-half-w", camera_from_vectors, half_of_the_width,
            "w = |upper right - upper left| / 2",
            "the width goes from edge to edge, and so does the height, which is right.",
            "everything twice as wide"),
    MISTAKE("V-half-h", camera_from_vectors, half_of_the_height,
            "h = |upper left - lower left| / 2",
            "the height goes from edge to edge, and so does the width, which is right.",
            "everything twice as high"),
    MISTAKE("V-both", camera_from_vectors, width_for_both, "h = w",
            "how high the plane is the left edge tells, from upper left to lower left.",
            "right where the plane is a square; elsewhere squashed or stretched"),
    MISTAKE("V-unit-r", camera_from_vectors, right_not_unit, "r = upper right - upper left",
            "the frame only says which way, so each of its vectors has length 1. Up and forward "
            "have.",
            "everything squeezed, or no picture"),
    MISTAKE("V-unit-u", camera_from_vectors, up_not_unit, "u = upper left - lower left",
            "the frame only says which way, so each of its vectors has length 1. Right and forward "
            "have.",
            "everything squeezed, or no picture"),
    MISTAKE("F-tiny", camera_from_points, small_points_refused, "refused where d, w or h < 1e-6",
            SMALL_WORLDS, "no picture of tiny worlds"),
    MISTAKE("K-tiny", camera_from_corner, small_edges_refused, "refused where d, w or h < 1e-6",
            SMALL_WORLDS, "no picture of tiny worlds"),
    MISTAKE("L-tiny", camera_from_look_at, near_places_refused, "refused where |at - eye| < 1e-6",
            SMALL_WORLDS, "no picture of tiny worlds"),
    MISTAKE("L-w-tiny", camera_from_look_at, small_widths_refused, "refused where w < 1e-6",
            SMALL_WORLDS, "no picture of tiny worlds"),
    MISTAKE("L12-tiny", camera_from_look_at, short_cross_products_refused,
            "refused where |(at - eye) x up| < 1e-6",
            "a cross product is short where its vectors are. Make them unit first, or divide by "
            "their lengths: what is left is the sine of the angle between them.",
            "no picture of tiny worlds, or where up is short"),
    MISTAKE("A-float", width_from_angle, width_in_float, "in float",
            "a float keeps 7 digits, and the width is asked for to 9. Use double.",
            "nothing amiss"),
    MISTAKE(
        "A-small", width_from_angle, small_angles_as_arcs, "the arc where the angle is below 1",
        "under a small angle arc and tangent are nearly the same, but not to 9 digits. No angle "
        "needs a case of its own.",
        "nothing amiss"),
    {0},
};
