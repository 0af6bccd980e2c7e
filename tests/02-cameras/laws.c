// laws.c - the laws of exercise 02: a camera is given if there is one; it is a valid
// camera; and it is the camera of the arguments.
//
// Close to the border between valid and refused these laws are silent: rounding may go either way.
#include "exercises/02-cameras.h"

#include "common/text.h"
#include "tests/judge/known.h"

// Ten times what the contract allows.
static const double enough = 1e-8;

static bool differs(double yours, double expected, double size)
{
    return !(fabs(yours - expected) <= enough * size);
}

// Shows both if they differ, with enough digits to see it.
static void same_vector(const char *what, vec3 yours, const char *other, vec3 expected, double size)
{
    if (!differs(vec3_length(yours - expected), 0, size))
        return;
    Apart a = apart_vec3(yours, expected);
    law_broken("%s %s, %s %s", what, a.yours.s, other, a.right.s);
}

static void same_number(const char *what, double yours, const char *other, double expected)
{
    if (!differs(yours, expected, expected))
        return;
    Apart a = apart(yours, expected);
    law_broken("%s %s, %s %s", what, a.yours.s, other, a.right.s);
}

static void unit(const char *name, vec3 v)
{
    if (differs(vec3_length(v), 1, 1))
        law_broken("your %s has length %s, and must have 1", name,
                   number_text_to(vec3_length(v), 9).s);
}

static void at_right_angles(const char *names, vec3 v, vec3 w)
{
    if (differs(vec3_dot(v, w), 0, 1))
        law_broken("your %s are not at right angles: their dot product is %s", names,
                   number_text(vec3_dot(v, w)).s);
}

// The laws of every camera, and the place of this one.
static void frame_from(vec3 eye, Camera c)
{
    if (camera_check(c) == CAMERA_NOT_FINITE)
        law_broken("you gave a camera in which a number is infinite or NaN");
    unit("forward", c.forward);
    unit("right", c.right);
    unit("up", c.up);
    at_right_angles("right and forward", c.right, c.forward);
    at_right_angles("up and forward", c.up, c.forward);
    at_right_angles("right and up", c.right, c.up);
    same_vector("your camera is at", c.origin, "and the eye at", eye, 1 + vec3_length(eye));
}

// ---- is there a camera? -----------------------------------------------------------------------

// A contract: the camera that it describes, and the reasons that it lists, the more frequent first.
typedef struct {
    const char *what_it_is, *reasons;
} Contract;

static const Contract of_rectangles = {
    "these corners are a rectangle straight ahead of the eye",
    "CAMERA_NO_RECTANGLE, _OFF_AXIS, _NO_DISTANCE, _NO_WIDTH, _NO_HEIGHT, _NOT_FINITE"};
static const Contract of_look_at = {
    "the view has a direction, an up, a width and an aspect",
    "CAMERA_NO_DIRECTION, _UP_ALONG_VIEW, _NO_WIDTH, _NO_HEIGHT, _NOT_FINITE"};

// Whether the camera must be refused; if so, no other law is named. Sure are the reasons that hold
// without a doubt, a bit each; those that may be given are more (facts.c). All reasons of the
// contract are listed together, so that nobody learns of them one at a time.
static bool is_settled(CameraFault yours, Contract contract)
{
    int sure = (int)law_facts()[0], may = (int)law_facts()[1], first = 0;
    while (first < CAMERA_FAULTS && (sure >> first & 1) == 0)
        first++;
    const char *true_reason = camera_fault_text((CameraFault)first);

    if ((int)yours < 0 || yours >= CAMERA_FAULTS)
        law_broken("%d was returned, which is not one of the reasons in common/camera.h",
                   (int)yours);
    else if (yours == CAMERA_OK && sure != 0)
        law_broken("you gave a camera, but these arguments do not describe one. Do you test for "
                   "each of the reasons of this contract? They are %s",
                   contract.reasons);
    else if (yours != CAMERA_OK && may == 0)
        law_broken("you refused it ('%s'), although %s", camera_fault_text(yours),
                   yours <= CAMERA_NOT_PERPENDICULAR
                       ? "it is a camera: the frame that you made is wrong, or rounded to float"
                       : contract.what_it_is);
    else if ((yours == CAMERA_NOT_UNIT || yours == CAMERA_NOT_PERPENDICULAR) &&
             (may >> yours & 1) == 0)
        law_broken(
            "%s is not a reason of this contract: camera_check found it in the frame that you "
            "made. Test the arguments before you make a frame of them. The reasons are %s",
            yours == CAMERA_NOT_UNIT ? "CAMERA_NOT_UNIT" : "CAMERA_NOT_PERPENDICULAR",
            contract.reasons);
    else if (yours != CAMERA_OK && sure != 0 && (may >> yours & 1) == 0)
        law_broken("you refused it because '%s'; but the reason is: %s", camera_fault_text(yours),
                   true_reason);
    return yours != CAMERA_OK || sure != 0;
}

// ---- rectangles -------------------------------------------------------------------------------

static double cosine(vec3 v, vec3 w)
{
    return fabs(vec3_dot(v, w)) / (vec3_length(v) * vec3_length(w)); // NaN if one is 0
}

#define COMPARE                                                                                    \
    "Compare a difference with CAMERA_TOLERANCE times the sum of width and height, and a "         \
    "cosine with CAMERA_TOLERANCE, not with 0 or a fixed length, and use no float"

// What an exact comparison finds in a rectangle: rounding. False if it finds nothing.
static bool is_refused_for_rounding(CameraFault yours, Corners v)
{
    vec3 top = v.upper_right - v.upper_left, bottom = v.lower_right - v.lower_left;
    vec3 left = v.upper_left - v.lower_left, right = v.upper_right - v.lower_right;
    vec3 middle = (v.upper_left + v.upper_right + v.lower_left + v.lower_right) / 4;
    double gap = fmax(vec3_length(top - bottom), vec3_length(left - right));
    double diagonals =
        fabs(vec3_length(v.upper_right - v.lower_left) - vec3_length(v.lower_right - v.upper_left));
    double corner = fmax(cosine(top, left), cosine(bottom, right));
    double unit_corner = fabs(vec3_dot(vec3_unit(top), vec3_unit(left)));
    double axis = fmax(cosine(top, middle), cosine(left, middle));
    double distances = fabs(vec3_length(v.upper_left) - vec3_length(v.lower_right)) +
                       fabs(vec3_length(v.upper_right) - vec3_length(v.lower_left));
    corner = fmax(corner, unit_corner);
    bool is_gap = yours == CAMERA_NO_RECTANGLE && gap + diagonals + corner > 0;
    bool is_beside = yours == CAMERA_OFF_AXIS && axis + distances > 0;
    if (is_gap)
        law_broken("you refuse rounding: this is a rectangle, but opposite edges, %s long, differ "
                   "by %s, and the cosine of an angle is %s. " COMPARE,
                   number_text_to(vec3_length(top), 2).s, number_text_to(gap, 2).s,
                   number_text_to(corner, 2).s);
    if (is_beside)
        law_broken("you refuse rounding: the eye is straight behind the middle, but the cosine "
                   "between an edge and the direction to the middle is %s. " COMPARE,
                   number_text_to(axis, 2).s);
    return is_gap || is_beside;
}

// The corners are counted from a place: from the eye, or from the origin.
static void rectangle(CameraFault yours, vec3 eye, Corners given, vec3 from, const Camera *camera)
{
    Corners v = {given.upper_left - from, given.upper_right - from, given.lower_left - from,
                 given.lower_right - from};
    vec3 top = v.upper_right - v.upper_left, left = v.upper_left - v.lower_left;
    vec3 middle = (v.upper_left + v.upper_right + v.lower_left + v.lower_right) / 4;
    double size = vec3_length(top) + vec3_length(left) + vec3_length(middle);
    double far = size + vec3_length(eye);
    if (far > 1e100)
        return; // squares leave the range of a double
    if ((law_facts()[1] == 0 && is_refused_for_rounding(yours, v)) ||
        is_settled(yours, of_rectangles))
        return;

    Camera c = *camera;
    frame_from(eye, c);
    same_number("your d is", c.distance, "and the middle of the corners is ahead by",
                vec3_length(middle));
    same_number("your w is", c.width, "and the length of the upper edge is", vec3_length(top));
    same_number("your h is", c.height, "and the length of the left edge is", vec3_length(left));
    vec3 ahead = c.distance * c.forward, across = c.width / 2 * c.right, up = c.height / 2 * c.up;
    same_vector("your camera's upper left corner is at", from + ahead - across + up,
                "and the given one is at", given.upper_left, far);
    same_vector("your camera's upper right corner is at", from + ahead + across + up,
                "and the given one is at", given.upper_right, far);
    same_vector("your camera's lower left corner is at", from + ahead - across - up,
                "and the given one is at", given.lower_left, far);
}

LAW(camera_from_vectors)
{
    rectangle(yours, eye, vectors, vec3_of(0, 0, 0), camera);
}

LAW(camera_from_points)
{
    rectangle(yours, eye, points, eye, camera);
}

LAW(camera_from_corner)
{
    vec3 above = lower_left + up;
    Corners corners = {above, above + across, lower_left, lower_left + across};
    rectangle(yours, eye, corners, eye, camera);
}

// ---- look-at ----------------------------------------------------------------------------------

LAW(camera_from_look_at)
{
    vec3 to_point = view.at - view.eye;
    double distance = vec3_length(to_point), up_length = vec3_length(view.up);
    if (distance > 1e50 || up_length > 1e50 || (up_length > 0 && up_length < 1e-50))
        return; // squares leave the range of a double
    double sine = vec3_length(vec3_cross(to_point, view.up)) / distance / up_length;
    if (yours == CAMERA_OK && law_facts()[0] == 1 << CAMERA_UP_ALONG_VIEW && sine > 0)
        law_broken("you gave a camera although up is along the view: the sine of the angle between "
                   "them is %s, and that is rounding. Compare it with CAMERA_TOLERANCE, not with 0",
                   number_text_to(sine, 2).s);
    if (is_settled(yours, of_look_at))
        return;

    Camera c = *camera;
    frame_from(view.eye, c);
    if (vec3_dot(c.forward, to_point) < 0)
        law_broken("your forward leads away from the point looked at");
    same_vector("your image plane has its middle at", c.origin + c.distance * c.forward,
                "and the point looked at is", view.at, distance + vec3_length(view.eye));
    double lean = vec3_dot(c.right, view.up) / up_length;
    if (vec3_dot(c.up, view.up) < 0)
        law_broken("your up points down: its dot product with the given up is %s",
                   number_text(vec3_dot(c.up, view.up)).s);
    if (differs(lean, 0, 1))
        law_broken("your camera is rolled: right is at %s degrees to the given up, not at 90",
                   number_text(acos(lean) * 180 / PI).s);
    bool is_left = vec3_dot(vec3_cross(c.right, c.up), c.forward) > 0;
    if (is_left != (world == LEFT_HANDED))
        law_broken("your frame is %s-handed, and the world is %s: right is on the wrong side",
                   is_left ? "left" : "right", is_left ? "right-handed" : "left-handed");
    same_number("your w is", c.width, "and the given width is", view.width);
    same_number("your h is", c.height, "and the aspect requires", view.width / view.aspect);
}

// ---- width from angle -------------------------------------------------------------------------

LAW(width_from_angle)
{
    if (!(degrees > 0 && degrees < 180 && distance > 0 && isfinite(distance)))
        return;
    double angle = 2 * atan(yours / 2 / distance) * 180 / PI;
    if (!(yours > 0))
        law_broken("an image plane has a positive width, not %s", number_text(yours).s);
    else if (fabs(angle - degrees) > enough * (degrees + 100 / distance))
        same_number("a plane as wide as yours is seen under an angle of", angle,
                    "and the given angle is", degrees);
}
