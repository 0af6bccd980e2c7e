// wrong.c - wrong answers to exercise 02.
#include "exercises/02-cameras.h"

#include "tests/judge/known.h"

#include <stddef.h>

// ---- answers in parts, which mistakes change ----------------------------------------------------

// Without a check of the result.
static CameraFault store(CameraFault fault, Camera found, Camera *camera)
{
    if (fault == CAMERA_OK)
        *camera = found;
    return fault;
}

// In each style (answer_style) another reason is looked for before all others; in style 0 none is.
static CameraFault first_for_rectangles(void)
{
    static const CameraFault first[] = {CAMERA_OK,       CAMERA_NOT_FINITE, CAMERA_NO_DISTANCE,
                                        CAMERA_NO_WIDTH, CAMERA_NO_HEIGHT,  CAMERA_NO_RECTANGLE,
                                        CAMERA_OFF_AXIS};
    return first[answer_style];
}

static CameraFault first_for_views(void)
{
    static const CameraFault first[] = {CAMERA_OK,           CAMERA_NOT_FINITE, CAMERA_NO_DISTANCE,
                                        CAMERA_NO_WIDTH,     CAMERA_NO_HEIGHT,  CAMERA_NO_DIRECTION,
                                        CAMERA_UP_ALONG_VIEW};
    return first[answer_style];
}

// As the blanks do: a camera in which camera_check finds a fault is refused as well.
static CameraFault give(CameraFault fault, Camera found, Camera *camera)
{
    return store(fault != CAMERA_OK ? fault : camera_check(found), found, camera);
}

static Corners moved(Corners corners, vec3 by)
{
    return (Corners){corners.upper_left + by, corners.upper_right + by, corners.lower_left + by,
                     corners.lower_right + by};
}

// A rectangle from its lower left corner and two edges.
static Corners spanned(vec3 corner, vec3 across, vec3 up)
{
    return (Corners){corner + up, corner + up + across, corner, corner + across};
}

// The camera of four vectors, whatever they are.
static Camera frame(vec3 eye, Corners v)
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
static double gap_of(Corners v)
{
    vec3 across = v.upper_right - v.upper_left;
    double gap = vec3_length(across - (v.lower_right - v.lower_left));
    double size = vec3_length(across) + vec3_length(v.upper_left - v.lower_left);
    return size > 0 ? gap / size : gap;
}

// To the last bit: NaN and the remains of rounding are not 0.
static bool is_exact_rectangle(Corners v, Camera c)
{
    return gap_of(v) == 0 && vec3_dot(c.right, c.up) == 0;
}

static bool is_exactly_ahead(Camera c)
{
    return vec3_dot(c.right, c.forward) == 0 && vec3_dot(c.up, c.forward) == 0;
}

// NaN is not off: the checks for numbers that are not finite must find it.
static bool is_off(double x)
{
    return fabs(x) > CAMERA_TOLERANCE;
}

// One reason by itself.
static bool is_faulty(CameraFault fault, vec3 eye, Corners v)
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
static CameraFault reason_but(CameraFault forgotten, vec3 eye, Corners v)
{
    CameraFault first = first_for_rectangles();
    if (first != forgotten && is_faulty(first, eye, v))
        return first;
    for (CameraFault fault = CAMERA_NOT_FINITE; fault < CAMERA_FAULTS; fault++)
        if (fault != forgotten && is_faulty(fault, eye, v))
            return fault;
    return CAMERA_OK;
}

static CameraFault reason(vec3 eye, Corners v)
{
    return reason_but(CAMERA_OK, eye, v);
}

// The right reason, except that one is overlooked if this holds.
static CameraFault overlooking(CameraFault overlooked, bool holds, vec3 eye, Corners v)
{
    bool is_overlooked = holds && reason(eye, v) == overlooked;
    return reason_but(is_overlooked ? overlooked : CAMERA_OK, eye, v);
}

// What is refused for another reason, and also for this one if that holds.
static CameraFault also(CameraFault fault, CameraFault another, bool holds)
{
    return fault == CAMERA_OK && holds ? another : fault;
}

// The camera of a look-at, whatever it is.
static Camera seen(LookAt view, Handedness world)
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

// One reason by itself.
static bool is_faulty_view(CameraFault fault, LookAt view)
{
    vec3 ahead = view.at - view.eye, sideways = vec3_cross(ahead, view.up);
    double length = vec3_length(ahead), up_length = vec3_length(view.up);
    switch (fault) {
    case CAMERA_NOT_FINITE:
        return !(isfinite(length) && isfinite(up_length) && isfinite(view.width) &&
                 !isnan(view.aspect));
    case CAMERA_NO_DIRECTION:
        return length == 0;
    case CAMERA_UP_ALONG_VIEW:
        return vec3_length(sideways) <= CAMERA_TOLERANCE * length * up_length;
    case CAMERA_NO_WIDTH:
        return view.width <= 0;
    case CAMERA_NO_HEIGHT:
        return view.aspect <= 0 || isinf(view.aspect);
    default:
        return false;
    }
}

// Without a view, up is along nothing.
static bool is_first_fault(CameraFault fault, LookAt view)
{
    return fault == first_for_views() && is_faulty_view(fault, view) &&
           (fault != CAMERA_UP_ALONG_VIEW || !is_faulty_view(CAMERA_NO_DIRECTION, view));
}

// The first reason, except for one that is forgotten (CAMERA_OK: none is).
static CameraFault view_reason_but(CameraFault forgotten, LookAt view)
{
    static const CameraFault order[] = {CAMERA_NOT_FINITE, CAMERA_NO_DIRECTION,
                                        CAMERA_UP_ALONG_VIEW, CAMERA_NO_WIDTH, CAMERA_NO_HEIGHT};
    CameraFault first = first_for_views();
    if (first != forgotten && is_first_fault(first, view))
        return first;
    for (size_t i = 0; i < sizeof order / sizeof order[0]; i++)
        if (order[i] != forgotten && is_faulty_view(order[i], view))
            return order[i];
    return CAMERA_OK;
}

static CameraFault view_reason(LookAt view)
{
    return view_reason_but(CAMERA_OK, view);
}

// ---- right answers ------------------------------------------------------------------------------

// The plane passes through the eye.
static bool is_without_distance(Corners v)
{
    vec3 across = v.upper_right - v.upper_left, up = v.upper_left - v.lower_left;
    vec3 normal = vec3_cross(across, up);
    double area = vec3_length(normal), size = vec3_length(across) * vec3_length(up);
    return area > CAMERA_TOLERANCE * size &&
           fabs(vec3_dot(normal, v.lower_left)) <= 1e-14 * area * vec3_length(v.lower_left);
}

// A reason that also holds, however it is found: neither NaN nor a line is a rectangle, nor is NaN
// straight ahead.
static bool is_also_faulty(CameraFault fault, vec3 eye, Corners v)
{
    Camera c = frame(eye, v);
    return is_faulty(fault, eye, v) || (fault == CAMERA_NO_DISTANCE && is_without_distance(v)) ||
           (fault == CAMERA_NO_RECTANGLE && isnan(gap_of(v) + vec3_dot(c.right, c.up))) ||
           (fault == CAMERA_OFF_AXIS && !vec3_is_finite(c.forward));
}

// As the reference, but of several reasons they return the one that the style looks for first.
static CameraFault from_vectors(vec3 eye, Corners vectors, Camera *camera)
{
    CameraFault first = first_for_rectangles();
    CameraFault fault = camera_from_vectors(eye, vectors, camera);
    return fault != CAMERA_OK && is_also_faulty(first, eye, vectors) ? first : fault;
}

static CameraFault from_points(vec3 eye, Corners points, Camera *camera)
{
    return from_vectors(eye, moved(points, -eye), camera);
}

// The same of a view: a plane through the eye has no distance, and a width or an aspect that is not
// positive spoils the height.
static bool is_also_faulty_view(CameraFault fault, LookAt view)
{
    double height = view.width / view.aspect;
    return is_first_fault(fault, view) ||
           (fault == CAMERA_NO_DISTANCE && is_faulty_view(CAMERA_NO_DIRECTION, view)) ||
           (fault == CAMERA_NO_WIDTH && !(view.width > 0)) ||
           (fault == CAMERA_NO_HEIGHT && !(height > 0 && view.aspect > 0)) ||
           (fault == CAMERA_NOT_FINITE && !(isfinite(height) && isfinite(view.aspect)));
}

static CameraFault from_look_at(LookAt view, Handedness world, Camera *camera)
{
    CameraFault first = first_for_views(), fault = camera_from_look_at(view, world, camera);
    return fault != CAMERA_OK && is_also_faulty_view(first, view) ? first : fault;
}

// The usual order of reasons, and six with another reason first.
static const int styles = 7;

OF_STEM(styles)

FREE(camera_from_vectors)
{
    return from_vectors(eye, vectors, camera);
}

FREE(camera_from_points)
{
    return from_points(eye, points, camera);
}

FREE(camera_from_corner)
{
    return from_vectors(eye, spanned(lower_left - eye, across, up), camera);
}

FREE(camera_from_look_at)
{
    return from_look_at(view, world, camera);
}

// ---- rectangles: the macros ---------------------------------------------------------------------

// Of the four vectors v the right answer finds the camera c, unless it finds a fault. A mistake
// changes these. finish: give, or store, without a check of the result.
#define RECTANGLE(finish, ...)                                                                     \
    Camera c = frame(eye, v);                                                                      \
    CameraFault fault = reason(eye, v);                                                            \
    __VA_ARGS__;                                                                                   \
    return finish(fault, c, camera);
#define VECTORS(finish, id, formula, why, picture, ...)                                            \
    WRONG(camera_from_vectors, id, formula, why, picture)                                          \
    {                                                                                              \
        Corners v = vectors;                                                                       \
        RECTANGLE(finish, __VA_ARGS__)                                                             \
    }
#define POINTS(finish, id, formula, why, picture, ...)                                             \
    WRONG(camera_from_points, id, formula, why, picture)                                           \
    {                                                                                              \
        Corners v = moved(points, -eye);                                                           \
        RECTANGLE(finish, __VA_ARGS__)                                                             \
    }
#define CORNER(finish, id, formula, why, picture, ...)                                             \
    WRONG(camera_from_corner, id, formula, why, picture)                                           \
    {                                                                                              \
        Corners v = spanned(lower_left - eye, across, up);                                         \
        RECTANGLE(finish, __VA_ARGS__)                                                             \
    }
// The same mistake in the three: V-store, F-store, K-store.
#define ALL_THREE(finish, name, formula, why, picture, ...)                                        \
    VECTORS(finish, "V-" name, formula, why, picture, __VA_ARGS__)                                 \
    POINTS(finish, "F-" name, formula, why, picture, __VA_ARGS__)                                  \
    CORNER(finish, "K-" name, formula, why, picture, __VA_ARGS__)

// ---- eye and four vectors: the numbers of the camera --------------------------------------------

VECTORS(give, "V-mirror", "w r = upper left - upper right",
        "this edge runs from right to left, but r points to the right.",
        "mirrored: left and right swapped", c.right = -c.right)
VECTORS(give, "V-down", "h u = lower left - upper left", "this edge runs down, but u points up.",
        "upside down", c.up = -c.up)
VECTORS(give, "V-behind", "d f = -mean",
        "the vectors lead from the eye to the plane, and so does f.",
        "the scene behind the eye, or nothing", c.forward = -c.forward)
VECTORS(give, "V-swap", "w r = upper left - lower left, h u = upper right - upper left",
        "right runs along the upper edge, up along the left one.",
        "transposed: rows become columns",
        c = (Camera){eye, c.up, c.right, c.forward, c.distance, c.height, c.width})
VECTORS(give, "V-sizes", "w = |upper left - lower left|, h = |upper right - upper left|",
        "this edge runs up the picture, so its length is the height of the picture.",
        "squashed: the picture's sides swapped",
        c = (Camera){eye, c.right, c.up, c.forward, c.distance, c.height, c.width})
VECTORS(give, "V-right-handed", "r = f x u",
        "this makes every frame right-handed. The rectangle itself says where right is, and it may "
        "have either handedness.",
        "every left-handed camera mirrored, including the deck's",
        c.right = vec3_cross(c.forward, c.up))
VECTORS(give, "V-left-handed", "r = u x f",
        "this makes every frame left-handed. The rectangle itself says where right is, and it may "
        "have either handedness.",
        "every right-handed camera mirrored", c.right = vec3_cross(c.up, c.forward))
VECTORS(give, "V-unit", "f = mean, r and u = edges",
        "the frame gives only directions, so each of its vectors has length 1. d, w and h hold the "
        "lengths.",
        "no picture: every camera is refused as not unit", c.forward *= c.distance)
#define EDGES "r = upper right - upper left, u = upper left - lower left"
#define TWICE "these are as long as the picture is wide and high, so w and h would count twice."
#define ONLY_IF_1 "too much: right only if w and h are 1"
VECTORS(store, "V-edges", EDGES, TWICE, ONLY_IF_1, c.right *= c.width, c.up *= c.height)
VECTORS(store, "V-edges-store", EDGES, TWICE, ONLY_IF_1, c.right *= c.width, c.up *= c.height,
        fault = CAMERA_OK)
VECTORS(give, "V-edges-check", EDGES,
        "the frame gives only directions, so each of its vectors has length 1. w and h hold the "
        "lengths.",
        "no picture: every camera is refused as not unit", c.right *= c.width, c.up *= c.height,
        fault = CAMERA_OK)
VECTORS(store, "V-forward", "f = mean", "this already reaches the plane, so d would count twice.",
        "too little: everything d times as big", c.forward *= c.distance)
VECTORS(give, "V-half", "w = |upper right - upper left| / 2, h likewise",
        "w and h run from edge to edge. Half of them is what you need from the middle.",
        "half of the width and height: everything twice as big", c.width /= 2, c.height /= 2)
VECTORS(give, "V-x-y", "w = difference of x, h = difference of y",
        "an edge may have any direction in space: its length depends on x, y and z.",
        "right only if r is along x and u along y", c.width = v.upper_right[0] - v.upper_left[0],
        c.height = v.upper_left[1] - v.lower_left[1])
// As it is; by authors who have not written the refusals yet and leave the checking to
// camera_check; and by those who check nothing.
#define SUM(finish, id, ...)                                                                       \
    VECTORS(finish, id, "d f = upper left + upper right + lower left + lower right",               \
            "each of the four goes as far ahead as the plane is, so their sum goes four times as " \
            "far.",                                                                                \
            "everything four times as big", c.distance *= 4, __VA_ARGS__)
SUM(give, "V-sum", (void)0)
SUM(give, "V-sum-check", fault = CAMERA_OK)
SUM(store, "V-sum-store", fault = CAMERA_OK)
VECTORS(give, "V-far", "d = |upper left|",
        "a corner is farther away than the middle of the plane is.", "everything a little too big",
        c.distance = vec3_length(v.upper_left))
VECTORS(give, "V-corner", "f along upper left",
        "straight ahead is the middle of the plane. The vector to a corner is not perpendicular to "
        "the edges.",
        "no picture: every camera is refused as not at right angles",
        c.forward = vec3_unit(v.upper_left))
VECTORS(give, "V-1", "d = 1", "f has length 1, but the plane is where the vectors end.",
        "too much: everything small, right only if d is 1", c.distance = 1)
VECTORS(give, "V-1-all", "d = 1, w / d, h / d",
        "the rays are right, but this is not the plane whose corners were given.",
        "no difference: the same picture with another plane", c.width /= c.distance,
        c.height /= c.distance, c.distance = 1)
VECTORS(give, "V-eye", "p = (0, 0, 0)",
        "the vectors start at the eye, and they do not say where it is.",
        "the scene seen from another place", c.origin = vec3_of(0, 0, 0))
VECTORS(store, "V-half-w", "w = |upper right - upper left| / 2",
        "the width goes from edge to edge. Your height already does.", "everything twice as wide",
        c.width /= 2)
VECTORS(store, "V-half-h", "h = |upper left - lower left| / 2",
        "the height goes from edge to edge. Your width already does.", "everything twice as high",
        c.height /= 2)
VECTORS(store, "V-both", "h = w",
        "the height of the plane is the length of the left edge, from upper left to lower left.",
        "right if the plane is a square; if not, squashed or stretched", c.height = c.width)
VECTORS(store, "V-unit-r", "r = upper right - upper left",
        "the frame gives only directions, so each of its vectors has length 1. Your up and forward "
        "have.",
        "everything squeezed, or no picture", c.right *= c.width)
VECTORS(store, "V-unit-u", "u = upper left - lower left",
        "the frame gives only directions, so each of its vectors has length 1. Your right and "
        "forward have.",
        "everything squeezed, or no picture", c.up *= c.height)
VECTORS(give, "V-points", "each vector - p",
        "these vectors start at the eye already. Only from points is the eye subtracted.",
        "no picture, unless the eye is at the origin: the camera is refused",
        return from_points(eye, v, camera))

// ---- eye and four vectors: which arguments are refused, and with which reason -------------------

VECTORS(store, "V-ok", "CAMERA_OK, always",
        "any four vectors have a mean and edges, but their ends are not always the corners of a "
        "rectangle straight ahead.",
        "a skewed picture of four corners that no camera has", fault = CAMERA_OK)
VECTORS(store, "V-nan", "NaN and infinity are accepted",
        "every comparison with NaN is false, so a test for 'too big' does not catch it.",
        "a black picture: a number of the camera is NaN",
        fault = reason_but(CAMERA_NOT_FINITE, eye, v))
VECTORS(store, "V-any", "any four corners are accepted",
        "a trapezoid or a parallelogram also has edges, but not the w and h of a camera.",
        "a picture, though no camera has these corners",
        fault = reason_but(CAMERA_NO_RECTANGLE, eye, v))
VECTORS(store, "V-lean", "a parallelogram is accepted",
        "its opposite edges are equal, but they are not at right angles.",
        "sheared, as if through a leaning window",
        fault = overlooking(CAMERA_NO_RECTANGLE, !is_off(gap_of(v)), eye, v))
VECTORS(give, "V-three", "three corners, never the lower right",
        "three corners make a rectangle whatever the fourth is, so the fourth may be anywhere.",
        "a picture, though one corner is not where it should be",
        v.lower_right = v.lower_left + v.upper_right - v.upper_left, c = frame(eye, v),
        fault = reason(eye, v))

// The length of a side or a diagonal compared with that of its opposite, for their size.
static bool is_as_long(vec3 one, vec3 other, double size)
{
    return !is_off((vec3_length(one) - vec3_length(other)) / size);
}

static bool has_equal_lengths(Corners v)
{
    vec3 top = v.upper_right - v.upper_left, left = v.upper_left - v.lower_left;
    double size = vec3_length(top) + vec3_length(left);
    return is_as_long(top, v.lower_right - v.lower_left, size) &&
           is_as_long(left, v.upper_right - v.lower_right, size) &&
           is_as_long(v.lower_right - v.upper_left, v.upper_right - v.lower_left, size);
}

VECTORS(store, "V-lengths", "edges and diagonals compared by length",
        "a saddle has equal edges and diagonals as well, and it is not even flat.",
        "a picture, though the corners are not in one plane",
        fault = overlooking(CAMERA_NO_RECTANGLE, has_equal_lengths(v), eye, v))
VECTORS(store, "V-axis-u", "r . f checked, u . f not",
        "the rectangle may be too high or too low, or lean back.", "skewed from top to bottom",
        fault = overlooking(CAMERA_OFF_AXIS, !is_off(vec3_dot(c.right, c.forward)), eye, v))
VECTORS(store, "V-axis-r", "u . f checked, r . f not",
        "the rectangle may be too far left or right, or turned to the side.",
        "skewed from left to right",
        fault = overlooking(CAMERA_OFF_AXIS, !is_off(vec3_dot(c.up, c.forward)), eye, v))

static bool is_hardly_off(Corners v, Camera c)
{
    double most = fmax(fabs(vec3_dot(c.right, c.up)), fabs(vec3_dot(c.right, c.forward)));
    return gap_of(v) < 0.01 && fmax(most, fabs(vec3_dot(c.up, c.forward))) < 0.01;
}

VECTORS(store, "V-loose", "right angles to 1%",
        "the contract allows only for rounding: one part in 1e9.",
        "hardly skewed, but the corners are not the given ones",
        bool loose = fault == CAMERA_NO_RECTANGLE || fault == CAMERA_OFF_AXIS;
        if (loose && is_hardly_off(v, c)) fault = CAMERA_OK)

#define ROUNDING                                                                                   \
    "rounding leaves about 1e-17 instead of 0. CAMERA_TOLERANCE is how much rounding may leave."
#define NOT_ROUND "no picture if the numbers are not round: the camera is refused"
VECTORS(give, "V-exact", "upper edge == lower edge and r . u == 0, exactly", ROUNDING, NOT_ROUND,
        fault = also(fault, CAMERA_NO_RECTANGLE, !is_exact_rectangle(v, c)))
// And NaN != 0 is true.
VECTORS(give, "V-exact-all", "!= 0 in every comparison", ROUNDING, NOT_ROUND,
        fault = reason_but(CAMERA_NOT_FINITE, eye, v),
        fault = also(fault, CAMERA_NO_RECTANGLE, !is_exact_rectangle(v, c)),
        fault = also(fault, CAMERA_OFF_AXIS, !is_exactly_ahead(c)))
VECTORS(store, "V-d", "d = 0 is not noticed",
        "an eye in the middle of its own image plane looks nowhere, and normalising (0, 0, 0) "
        "gives NaN.",
        "a black picture: forward is NaN", fault = reason_but(CAMERA_NO_DISTANCE, eye, v))
VECTORS(store, "V-w", "w = 0 is not noticed",
        "an edge of length 0 has no direction, and normalising it gives NaN.",
        "a black picture: right is NaN", fault = reason_but(CAMERA_NO_WIDTH, eye, v))
VECTORS(store, "V-h", "h = 0 is not noticed",
        "an edge of length 0 has no direction, and normalising it gives NaN.",
        "a black picture: up is NaN", fault = reason_but(CAMERA_NO_HEIGHT, eye, v))
VECTORS(give, "V-reason", "CAMERA_NO_RECTANGLE for every fault",
        "a rectangle that is only in the wrong place is still a rectangle, and the caller wants to "
        "know what to correct.",
        "refused, but for another reason",
        fault = fault == CAMERA_OK ? CAMERA_OK : CAMERA_NO_RECTANGLE)
VECTORS(store, "V-never", "*camera never stored",
        "CAMERA_OK promises that *camera holds the camera.",
        "the picture of whatever camera was there before", return fault)

// Right, except for how the gap or the angle is compared with CAMERA_TOLERANCE.
VECTORS(store, "V-gap", "gap between the edges > 1e-9",
        "how far the edges may differ depends on their length. In a large world rounding leaves "
        "more than that, and in a tiny one every shape passes.",
        "no picture of large worlds, and a wrong one of tiny ones",
        bool gapes = is_off(vec3_length(v.upper_right - v.upper_left -
                                        (v.lower_right - v.lower_left)));
        fault = also(overlooking(CAMERA_NO_RECTANGLE, !gapes && !is_off(vec3_dot(c.right, c.up)),
                                 eye, v),
                     CAMERA_NO_RECTANGLE, gapes))
VECTORS(store, "V-dot", "|across . up| > 1e-9, with edges of any length",
        "a dot product grows with both lengths. Normalise the edges, or divide by the lengths: "
        "then only the angle is left.",
        "no picture of large worlds, and a wrong one of tiny ones",
        bool leans = is_off(c.width * c.height * vec3_dot(c.right, c.up));
        fault = also(overlooking(CAMERA_NO_RECTANGLE, !leans && !is_off(gap_of(v)), eye, v),
                     CAMERA_NO_RECTANGLE, leans))

// ---- the same mistake in two of the forms, or in all --------------------------------------------

#define VECTORS_AND_POINTS(finish, name, formula, why, picture, ...)                               \
    VECTORS(finish, "V-" name, formula, why, picture, __VA_ARGS__)                                 \
    POINTS(finish, "F-" name, formula, why, picture, __VA_ARGS__)
#define VECTORS_AND_CORNER(finish, name, formula, why, picture, ...)                               \
    VECTORS(finish, "V-" name, formula, why, picture, __VA_ARGS__)                                 \
    CORNER(finish, "K-" name, formula, why, picture, __VA_ARGS__)
VECTORS_AND_POINTS(give, "check", "only the checks of camera_check",
                   "it sees only your frame, never the four corners: it cannot know that the "
                   "fourth is wrong, nor that the shape or its place is wrong.",
                   "some refused, but for another reason; some accepted", fault = CAMERA_OK)
VECTORS_AND_CORNER(store, "axis", "a rectangle anywhere is accepted",
                   "f leads to its middle, but may not be perpendicular to it there.",
                   "a skewed picture, as of a plane seen from the side",
                   fault = reason_but(CAMERA_OFF_AXIS, eye, v))
VECTORS_AND_CORNER(give, "exact-axis", "r . f == 0 and u . f == 0, exactly", ROUNDING, NOT_ROUND,
                   fault = also(fault, CAMERA_OFF_AXIS, !is_exactly_ahead(c)))
ALL_THREE(store, "store", "stored, then checked",
          "if the camera is refused, *camera must stay as it was, but this overwrites it.",
          "the previous camera is lost", *camera = c)

static const double tiny = 1e-6;

static CameraFault too_small(Camera c)
{
    return c.distance < tiny ? CAMERA_NO_DISTANCE
           : c.width < tiny  ? CAMERA_NO_WIDTH
           : c.height < tiny ? CAMERA_NO_HEIGHT
                             : CAMERA_OK;
}

#define SMALL_WORLDS                                                                               \
    "a length is not small in itself, only compared with another one: a whole world can be "       \
    "smaller than that."

ALL_THREE(store, "tiny", "refused if d, w or h < 1e-6", SMALL_WORLDS, "no picture of tiny worlds",
          fault = fault == CAMERA_OK ? too_small(c) : fault)

// ---- eye and four points ------------------------------------------------------------------------

WRONG_LINE(camera_from_points, "F-vectors", "the points as vectors",
           "points are counted from the origin, and vectors from the eye.",
           "no picture, unless the eye is at the origin: the camera is refused",
           return from_vectors(eye, points, camera))
WRONG_LINE(camera_from_points, "F-plus", "point + p",
           "point + p goes from the eye back to the origin, and then on to the point.",
           "no picture, unless the eye is at the origin: the camera is refused",
           return from_vectors(eye, moved(points, eye), camera))
WRONG_LINE(camera_from_points, "F-from", "p - point",
           "these vectors lead from the plane back to the eye, so the whole frame is reversed.",
           "the scene behind the eye, upside down",
           return from_vectors(eye,
                               (Corners){eye - points.upper_left, eye - points.upper_right,
                                         eye - points.lower_left, eye - points.lower_right},
                               camera))
WRONG_LINE(camera_from_points, "F-eye", "p = (0, 0, 0)",
           "the camera is where the eye is, and the vectors alone do not say where that is.",
           "the scene seen from another place",
           return from_vectors(vec3_of(0, 0, 0), moved(points, -eye), camera))
WRONG_LINE(camera_from_points, "F-circle", "the corners taken in a circle",
           "they come row by row, in reading order: after the upper right comes the lower left.",
           "no picture: every camera is refused",
           return from_points(eye,
                              (Corners){points.upper_left, points.upper_right, points.lower_right,
                                        points.lower_left},
                              camera))
WRONG_LINE(camera_from_points, "F-lower", "the lower corners first",
           "they come in reading order: the upper row first. Your up points down.", "upside down",
           return from_points(eye,
                              (Corners){points.lower_left, points.lower_right, points.upper_left,
                                        points.upper_right},
                              camera))
WRONG_LINE(camera_from_points, "F-right", "the right corners first",
           "they come in reading order: in each row, left before right. Your right points left.",
           "mirrored: left and right swapped",
           return from_points(eye,
                              (Corners){points.upper_right, points.upper_left, points.lower_right,
                                        points.lower_left},
                              camera))
POINTS(store, "F-ok", "CAMERA_OK, always",
       "any four points have a mean and edges, but they are not always the corners of a rectangle "
       "straight ahead.",
       "a skewed picture of four points that no camera has", fault = CAMERA_OK)
POINTS(store, "F-dropped", "the reason is not returned",
       "camera_from_vectors refused the camera, but you return CAMERA_OK.",
       "the picture of whatever camera was there before", from_vectors(eye, v, camera);
       return CAMERA_OK)

// ---- eye, lower left corner and two vectors -----------------------------------------------------

WRONG_LINE(camera_from_corner, "K-vector", "the lower left corner as a vector",
           "it is a point, counted from the origin, and the vectors of a camera start at the eye.",
           "no picture, unless the eye is at the origin: the camera is refused",
           return from_vectors(eye, spanned(lower_left, across, up), camera))
WRONG_LINE(camera_from_corner, "K-upper", "upper left = the corner, lower left = the corner - up",
           "the given corner is a lower one, and up leads up from it.",
           "no picture: the plane is too low, and the camera is refused",
           return from_points(eye, spanned(lower_left - up, across, up), camera))
WRONG_LINE(camera_from_corner, "K-middle", "d f = the corner - p",
           "this leads to the lower left corner, but forward must lead to the middle of the plane.",
           "no picture: the plane is too low and too far left, and the camera is refused",
           return from_points(eye, spanned(lower_left - across / 2 - up / 2, across, up), camera))
WRONG_LINE(camera_from_corner, "K-swap", "w r = up, h u = across",
           "across is the lower edge, from left to right.", "transposed: rows become columns",
           return from_points(eye, spanned(lower_left, up, across), camera))
WRONG_LINE(camera_from_corner, "K-corners", "w r = across - the corner, h u = up - the corner",
           "across and up are the edges themselves, not the corners where they end.",
           "no picture: every camera is refused",
           return from_points(eye, spanned(lower_left, across - lower_left, up - lower_left),
                              camera))
CORNER(give, "K-unit", "r = across, u = up",
       "the frame gives only directions, so each of its vectors has length 1. w and h hold the "
       "lengths.",
       "no picture: every camera is refused as not unit", c.right = across, c.up = up)
// From forward and up, as in a look-at, and for one handedness.
CORNER(give, "K-hand", "r = u x f",
       "this makes every frame left-handed. The lower edge says where right is, and the camera may "
       "have either handedness.",
       "every right-handed camera mirrored", c.right = vec3_cross(c.up, c.forward))
CORNER(give, "K-square", "h = |across|",
       "this is the width. They are equal only if the plane is a square.", "stretched in height",
       c.height = c.width)
CORNER(give, "K-straight", "up made perpendicular to across",
       "that is for the up of a look-at, which may lean. Here up is an edge of the plane, and an "
       "edge that leans does not make a rectangle.",
       "a picture, but its upper corners are not where you put them",
       c.up = vec3_unit(c.up - vec3_dot(c.up, c.right) * c.right),
       fault = reason_but(CAMERA_NO_RECTANGLE, eye, v))
CORNER(give, "K-check", "only the checks of camera_check",
       "it sees only your frame, never the corner and the edges: it cannot know that the angle "
       "between them or their place is wrong.",
       "refused, but for another reason", fault = CAMERA_OK)
CORNER(store, "K-ok", "CAMERA_OK, always",
       "any corner and two vectors make four corners, but not always a rectangle straight ahead.",
       "a skewed picture of corners that no camera has", fault = CAMERA_OK)
CORNER(
    store, "K-lean", "any two vectors are accepted",
    "if they are not at right angles they span a parallelogram, and an image plane is a rectangle.",
    "sheared, as if through a leaning window", fault = reason_but(CAMERA_NO_RECTANGLE, eye, v))
CORNER(give, "K-exact", "across . up == 0, exactly", ROUNDING, NOT_ROUND,
       fault = also(fault, CAMERA_NO_RECTANGLE, vec3_dot(across, up) != 0))
// And NaN != 0 is true.
CORNER(give, "K-exact-all", "!= 0 in every comparison", ROUNDING, NOT_ROUND,
       fault = reason_but(CAMERA_NOT_FINITE, eye, v),
       fault = also(fault, CAMERA_NO_RECTANGLE, vec3_dot(across, up) != 0),
       fault = also(fault, CAMERA_OFF_AXIS, !is_exactly_ahead(c)))

// ---- look-at: the numbers of the camera ---------------------------------------------------------

// The same of a view.
#define LOOK(finish, id, formula, why, picture, ...)                                               \
    WRONG(camera_from_look_at, id, formula, why, picture)                                          \
    {                                                                                              \
        Camera c = seen(view, world);                                                              \
        CameraFault fault = view_reason(view);                                                     \
        __VA_ARGS__;                                                                               \
        return finish(fault, c, camera);                                                           \
    }
// And again of authors who have not written the refusals yet: they leave the checking to
// camera_check, or in L10-store return the camera unchecked.
#define LOOK_CHECKED(id, formula, why, picture, ...)                                               \
    LOOK(give, id, formula, why, picture, __VA_ARGS__)                                             \
    LOOK(give, id "-check", formula, why, picture, __VA_ARGS__, fault = CAMERA_OK)
// As the reference in another world.
#define IN_WORLD(id, formula, why, picture, another)                                               \
    WRONG(camera_from_look_at, id, formula, why, picture)                                          \
    {                                                                                              \
        return from_look_at(view, another, camera);                                                \
    }                                                                                              \
    LOOK(give, id "-check", formula, why, picture, c = seen(view, another), fault = CAMERA_OK)

LOOK_CHECKED(
    "L1", "d f = eye - at",
    "this leads from the point looked at back to the eye. You look in the opposite direction.",
    "nothing, or the scene behind you", c.forward = -c.forward,
    c.right = -c.right /* it follows from the cross product */)
LOOK(give, "L1-only", "f = -f at the end",
     "r and u are right, but f leads away from the point looked at. (In OpenGL the z axis is -f; "
     "here f points ahead.)",
     "the scene behind you, mirrored", c.forward = -c.forward)
IN_WORLD("L2", "both cross products in the other order",
         "this is the camera of a world of the other handedness: its right is your left.",
         "mirrored: left and right swapped", world == RIGHT_HANDED ? LEFT_HANDED : RIGHT_HANDED)
LOOK(give, "L2-turned", "the cross product for r in the other order",
     "r then points to the left; and u, made from r, points down.", "turned by 180 degrees",
     c.right = -c.right, c.up = -c.up /* it follows from the cross product */)
IN_WORLD(
    "L2-right", "r = f x up in either world",
    "this is right in a right-handed world. In a left-handed one, r must point to the other side.",
    "mirrored in a left-handed world, as the deck's is", RIGHT_HANDED)
IN_WORLD(
    "L2-left", "r = up x f in either world",
    "this is right in a left-handed world. In a right-handed one, r must point to the other side.",
    "mirrored in a right-handed world", LEFT_HANDED)
LOOK(give, "L2-down", "the cross product for u in the other order",
     "u then points away from the given up.", "upside down", c.up = -c.up)
LOOK(give, "L2-up", "u = r x f in either world",
     "r was reversed for the left-handed world, and this reverses u as well.",
     "upside down in a left-handed world", c.up = vec3_cross(c.right, c.forward))
#define UP_UNCHANGED                                                                               \
    "up may have any length, and may lean towards the view. The frame's own up has length 1 and "  \
    "is perpendicular to f."
LOOK_CHECKED("L3", "u = up, unchanged", UP_UNCHANGED,
             "no picture, unless up fits by luck: the camera is refused", c.up = view.up)
LOOK(store, "L3-stored", "u = up, unchanged and unchecked", UP_UNCHANGED,
     "stretched or squashed in height, and skewed if the camera looks up or down", c.up = view.up)
LOOK(give, "L3-unit", "u = up / |up|",
     "if the camera looks up or down, the given up leans towards the view: it is not perpendicular "
     "to f.",
     "no picture if the camera looks up or down: the camera is refused", c.up = vec3_unit(view.up))

static double length_of_cross(LookAt view, Camera c)
{
    return vec3_length(vec3_cross(c.forward, view.up));
}

#define AREA                                                                                       \
    "the length of a cross product is the area between its vectors, and that shrinks if up leans."
#define NOT_UNIT "no picture, unless up fits by luck: it is refused as not unit"
LOOK(give, "L4", "r = the cross product, not normalised", AREA, NOT_UNIT,
     c.right *= length_of_cross(view, c))
LOOK(store, "L4-stored", "r = the cross product, neither normalised nor checked", AREA,
     "stretched sideways if up leans, squashed if it is long", c.right *= length_of_cross(view, c))
#define BOTH_NOT_UNIT(finish, id, picture, ...)                                                    \
    LOOK(finish, id, "r = the cross product, not normalised, and u from it", AREA, picture,        \
         c.right *= length_of_cross(view, c), c.up *= length_of_cross(view, c), __VA_ARGS__)
#define STRETCHED "stretched or squashed if up leans or is long"
BOTH_NOT_UNIT(give, "L4-check", NOT_UNIT, fault = CAMERA_OK)
BOTH_NOT_UNIT(store, "L4-store", STRETCHED, fault = CAMERA_OK)
BOTH_NOT_UNIT(store, "L4-both", STRETCHED, (void)0)
LOOK(give, "L4-forward", "f = at - eye",
     "this is d f. The frame gives only directions, so f has length 1.",
     "no picture, unless d is 1: it is refused as not unit", c.forward = view.at - view.eye)
#define TURNED_ROUND "a picture of aspect 2 is wider than high, but this makes it higher than wide."
#define ELLIPSES "circles become ellipses"
LOOK_CHECKED("L10", "h = w aspect", TURNED_ROUND, ELLIPSES, c.height = view.width * view.aspect)
LOOK(store, "L10-store", "h = w aspect", TURNED_ROUND, ELLIPSES,
     c.height = view.width * view.aspect, fault = CAMERA_OK)
LOOK(give, "L11", "h = w", "a picture is as high as it is wide only if its aspect is 1.", ELLIPSES,
     c.height = view.width)
LOOK(give, "L11-width", "w = width aspect, h = width",
     "the aspect is right, but the given width is the width, not the height.",
     "everything at the wrong size", view.width *= view.aspect, c = seen(view, world),
     fault = view_reason(view))
LOOK(give, "L-1", "d = 1",
     "the image plane passes through the point looked at, so d is the distance to that point.",
     "too much: everything small, right only if d is 1", c.distance = 1)
LOOK(give, "L-squared", "d = (at - eye) . (at - eye)", "this is the square of the length.",
     "too little: everything d times as big", c.distance *= c.distance)
LOOK(give, "L-direction", "d f = at",
     "at is a point, counted from the origin; the view starts at the eye.",
     "another part of the scene, unless the eye is at the origin", view.at += view.eye;
     return from_look_at(view, world, camera))

// Component by component, in place of the cross products.
static Camera of_products(LookAt view, Camera c)
{
    c.right = vec3_unit(c.forward * view.up);
    c.up = c.right * c.forward;
    return c;
}

static bool is_product_short(LookAt view)
{
    double length = vec3_length(vec3_unit(view.at - view.eye) * view.up);
    return length <= CAMERA_TOLERANCE * vec3_length(view.up);
}

#define PRODUCT(finish, id, ...)                                                                   \
    LOOK(finish, id, "r = f * up, normalised",                                                     \
         "v * w multiplies component by component, and the result is perpendicular to "            \
         "neither. The cross product is vec3_cross.",                                              \
         "no picture, or one skewed beyond recognition", c = of_products(view, c), __VA_ARGS__)
PRODUCT(give, "L-product", fault = view_reason_but(CAMERA_UP_ALONG_VIEW, view),
        fault = also(fault, CAMERA_UP_ALONG_VIEW, is_product_short(view)))
PRODUCT(give, "L-product-check", fault = CAMERA_OK)
PRODUCT(store, "L-product-store", fault = CAMERA_OK)

// ---- look-at: which arguments are refused, and with which reason --------------------------------

LOOK(store, "L-ok", "CAMERA_OK, always",
     "the arguments may have no direction of view, an unusable up, or a width below 0.",
     "a black picture: every number is NaN", fault = CAMERA_OK)
LOOK(give, "L-check", "only the checks of camera_check",
     "it sees your frame after a division by 0 has made NaN of it, and can no longer find the "
     "reason.",
     "refused, but for another reason", fault = CAMERA_OK)
LOOK(store, "L12", "up along the view is not noticed",
     "the cross product is then 0 and has no direction, and normalising it gives NaN.",
     "a black picture: right and up are NaN", fault = view_reason_but(CAMERA_UP_ALONG_VIEW, view))
LOOK(give, "L12-nan", "up along the view reported as not finite, or not noticed",
     "the arguments were finite. The cross product is 0, or close to 0 after rounding: look at its "
     "length before you divide.",
     "refused, but for another reason; or rolled at random",
     fault = view_reason_but(CAMERA_UP_ALONG_VIEW, view))
LOOK(store, "L12-zero", "up = (0, 0, 0) is not noticed",
     "it points nowhere, so the camera could be rolled by any angle.",
     "a black picture: right and up are NaN", fault = vec3_length(view.up) == 0 ? CAMERA_OK : fault)
LOOK(store, "L12-against", "up against the view is not noticed",
     "straight back is along the view as well: no part of up is perpendicular to the view.",
     "a black picture: right and up are NaN",
     bool against = fault == CAMERA_UP_ALONG_VIEW && vec3_dot(view.up, c.forward) < 0;
     fault = view_reason_but(against ? CAMERA_UP_ALONG_VIEW : CAMERA_OK, view))
LOOK(give, "L12-exact", "|f x up| == 0",
     "rounding leaves about 1e-17 instead of 0, and that points in a random direction.",
     "rolled at random around the view", fault = view_reason_but(CAMERA_UP_ALONG_VIEW, view),
     fault = also(fault, CAMERA_UP_ALONG_VIEW, length_of_cross(view, c) == 0))
LOOK(give, "L12-exact-only", "|f x up| == 0, and no other check",
     "rounding leaves about 1e-17 instead of 0, and that points in a random direction. And if at "
     "is the eye, f is NaN.",
     "rolled at random around the view, or black",
     fault = also(CAMERA_OK, CAMERA_UP_ALONG_VIEW, length_of_cross(view, c) == 0))
LOOK(give, "L12-short", "|f x up| <= 1e-9, however short up is",
     "up may have any length. It is along the view if the cross product is short compared with up "
     "itself.",
     "no picture if up is short: the camera is refused",
     fault = also(fault, CAMERA_UP_ALONG_VIEW, length_of_cross(view, c) <= CAMERA_TOLERANCE))
LOOK(give, "L12-lean", "f . up > 0.99 is refused",
     "an up that leans far still says which way is up, unless it is along the view to within 1e-9.",
     "no picture if the camera looks steeply up or down",
     fault = also(fault, CAMERA_UP_ALONG_VIEW,
                  fabs(vec3_dot(vec3_unit(view.up), c.forward)) > 0.99))
LOOK(store, "L-eye", "at = eye is not noticed",
     "the eye then looks nowhere, and normalising (0, 0, 0) gives NaN.",
     "a black picture: every number is NaN",
     fault = fault == CAMERA_NO_DIRECTION ? CAMERA_OK : fault)
LOOK(give, "L-eye-up", "at = eye reported as an up along the view",
     "without a direction of view every cross product is 0, but up is not the reason.",
     "refused, but for another reason", fault = view_reason_but(CAMERA_NO_DIRECTION, view))
LOOK(store, "L-w", "width <= 0 is not noticed",
     "a plane of width 0 shows nothing, and one of width -2 is reversed.",
     "nothing, or turned by 180 degrees", fault = view_reason_but(CAMERA_NO_WIDTH, view))
LOOK(store, "L-h", "aspect <= 0 is not noticed",
     "the height is then infinite, or negative and runs down.", "upside down, or nothing",
     fault = view_reason_but(CAMERA_NO_HEIGHT, view))
LOOK(store, "L-nan", "NaN and infinity are accepted",
     "every comparison with NaN is false, so a test for 'too small' does not catch it.",
     "a black picture: a number of the camera is NaN",
     fault = view_reason_but(CAMERA_NOT_FINITE, view))
LOOK(store, "L-nan-size", "NaN in width and aspect is accepted",
     "NaN <= 0 is false, so a test for 'not positive' does not catch it.",
     "a black picture: w and h are NaN",
     fault = isfinite(view.width) && isfinite(view.aspect) ? fault : CAMERA_OK)
LOOK(store, "L-store", "stored, then checked",
     "if the camera is refused, *camera must stay as it was, but this overwrites it.",
     "the previous camera is lost", *camera = c)

// A limit that the author added: what is below it is refused, and all else is right.
#define LIMIT(id, formula, why, picture, reason, small)                                            \
    WRONG(camera_from_look_at, id, formula, why, picture)                                          \
    {                                                                                              \
        bool refused = view_reason(view) == CAMERA_OK && (small);                                  \
        return refused ? reason : from_look_at(view, world, camera);                               \
    }

LIMIT("L-tiny", "refused if |at - eye| < 1e-6", SMALL_WORLDS, "no picture of tiny worlds",
      CAMERA_NO_DIRECTION, vec3_length(view.at - view.eye) < tiny)
LIMIT("L-w-tiny", "refused if w < 1e-6", SMALL_WORLDS, "no picture of tiny worlds", CAMERA_NO_WIDTH,
      view.width < tiny)
LIMIT("L12-tiny", "refused if |(at - eye) x up| < 1e-6",
      "a cross product is short if its vectors are short. Normalise them first, or divide by their "
      "lengths: then only the sine of the angle is left.",
      "no picture of tiny worlds, or if up is short", CAMERA_UP_ALONG_VIEW,
      vec3_length(vec3_cross(view.at - view.eye, view.up)) < tiny)

// ---- width from angle -------------------------------------------------------------------------

#define WIDTH(id, formula, why, picture, width)                                                    \
    WRONG(width_from_angle, id, formula, why, picture)                                             \
    {                                                                                              \
        return width;                                                                              \
    }

WIDTH("L6", "w = 2 d tan(angle)",
      "the view direction cuts the angle in two, and each of the two right triangles has only half "
      "of it at the eye.",
      "far too much: everything small (and nothing at all from 90 degrees on)",
      2 * distance * tan(degrees * PI / 180))
WIDTH("L7", "w = 2 d tan(angle / 2), in degrees",
      "tan expects radians, so 90 is many times round the circle.",
      "a wild width, sometimes negative", 2 * distance * tan(degrees / 2))
WIDTH("L7-back", "w = 2 d tan(angle / 2 * 180 / pi)",
      "half a turn is pi radians, and tan expects radians. This multiplies instead of dividing.",
      "a wild width, sometimes negative", 2 * distance * tan(degrees / 2 * 180 / PI))
WIDTH("L7-behind", "w = 2 d tan(angle / 2) * pi / 180",
      "convert the angle to radians before tan, not the tangent after it.",
      "a wild width, mostly tiny", 2 * distance * tan(degrees / 2) * PI / 180)
WIDTH("L6-half", "w = d tan(angle / 2)",
      "this is the width from the middle of the plane to one edge, not from edge to edge.",
      "half of the width: everything twice as big", tan(degrees *PI / 360) * distance)
WIDTH("L6-once", "w = d tan(angle)",
      "the triangle of eye, left edge and right edge has no right angle, so the tangent of its "
      "whole angle does not help. Cut it in two first.",
      "too much, and nothing at all from 90 degrees on", tan(degrees *PI / 180) * distance)
WIDTH("A-distance", "w = 2 tan(angle / 2)",
      "twice as far away, the same angle spans twice the width.", "right only if d = 1",
      2 * tan(degrees * PI / 360))
WIDTH("A-divided", "w = 2 tan(angle / 2) / d",
      "the farther the plane, the wider it must be to fill the same angle.", "right only if d = 1",
      2 * tan(degrees * PI / 360) / distance)
WIDTH("A-arc", "w = d angle",
      "this is the length of an arc around the eye. The image plane is flat, and cuts the sides of "
      "the angle farther out.",
      "a little too narrow, more so for wide angles", PI / 180 * degrees * distance)
WIDTH(
    "A-chord", "w = 2 d sin(angle / 2)",
    "d leads to the middle of the plane, so it is a leg of the right triangle, not the hypotenuse.",
    "a little too narrow, more so for wide angles", 2 * distance * sin(degrees * PI / 360))
WIDTH("A-cotangent", "w = 2 d / tan(angle / 2)",
      "this swaps the triangle's legs: a wider angle would see less.", "right only at 90 degrees",
      2 * distance / tan(degrees * PI / 360))
WIDTH("A-pi", "w = 2 d tan(angle / 2), with 3.14 as pi",
      "three digits of pi give three digits of the width. common/vec3.h has PI.",
      "no visible difference, but the fourth digit is wrong",
      2 * distance * tan(degrees * 3.14 / 360))
WIDTH("A-int", "w = 2 d tan(angle * (1 / 2)), in integers",
      "in C, 1 / 2 is an integer division with the result 0, so this is the tangent of 0. Use 0.5, "
      "or / 2.",
      "nothing: the image plane has width 0", 2 * distance * tan(degrees * (1 / 2) * PI / 180))
WIDTH("A-whole", "w = 2 d tan(angle / 2), in whole degrees",
      "in integers 45 / 2 is 22: the digits after the decimal point are lost.",
      "a little too narrow at odd angles", 2 * distance * tan((int)degrees / 2 * PI / 180))
WIDTH("A-float", "in float", "a float has 7 digits, and the width needs 9. Use double.",
      "no visible difference", 2 * (float)distance * tanf((float)degrees / 2 * (float)PI / 180))
WIDTH("A-small", "the arc if the angle is below 1",
      "for a small angle arc and tangent are nearly the same, but not to 9 digits. No angle needs "
      "a special case.",
      "no visible difference",
      degrees < 1 ? distance * degrees * PI / 180 : 2 * distance * tan(degrees * PI / 360))
