// 02-cameras.c - wrong answers to exercise 02.
//
// Most are a right answer with one thing wrong, so a right answer comes first, in two steps that
// can go wrong one by one: the numbers, never checked, and the reason why they are no camera.
#include "exercises/02-cameras.h"

#include "tests/mistakes/mistakes.h"

static CameraFault store(CameraFault fault, Camera found, Camera *camera)
{
    if (fault == CAMERA_OK)
        *camera = found;
    return fault;
}

// ---- eye and four vectors ---------------------------------------------------------------------

static Camera frame(vec3 eye, Corners v)
{
    vec3 across = v.upper_right - v.upper_left, up = v.upper_left - v.lower_left;
    vec3 middle = 0.5 * (v.upper_right + v.lower_left);
    return (Camera){.origin = eye,
                    .right = vec3_unit(across),
                    .up = vec3_unit(up),
                    .forward = vec3_unit(middle),
                    .distance = vec3_length(middle),
                    .width = vec3_length(across),
                    .height = vec3_length(up)};
}

static bool is_small(double x)
{
    return fabs(x) <= CAMERA_TOLERANCE;
}

// Each reason by itself.
static bool is_faulty(CameraFault fault, vec3 eye, Corners v)
{
    Camera c = frame(eye, v);
    vec3 gap = v.upper_right - v.upper_left - (v.lower_right - v.lower_left);
    switch (fault) {
    case CAMERA_NOT_FINITE:
        return !vec3_is_finite(eye) || !isfinite(c.distance) || !isfinite(vec3_length(gap)) ||
               !isfinite(c.width) || !isfinite(c.height);
    case CAMERA_NO_DISTANCE:
        return c.distance == 0;
    case CAMERA_NO_WIDTH:
        return c.width == 0;
    case CAMERA_NO_HEIGHT:
        return c.height == 0;
    case CAMERA_NO_RECTANGLE:
        return !is_small(vec3_length(gap)) || !is_small(vec3_dot(c.right, c.up));
    case CAMERA_OFF_AXIS:
        return !is_small(vec3_dot(c.right, c.forward)) || !is_small(vec3_dot(c.up, c.forward));
    default:
        return false;
    }
}

// The first reason, but for one that is forgotten.
static CameraFault reason_but(CameraFault forgotten, vec3 eye, Corners v)
{
    for (CameraFault fault = CAMERA_NOT_FINITE; fault < CAMERA_FAULTS; fault++)
        if (fault != forgotten && is_faulty(fault, eye, v))
            return fault;
    return CAMERA_OK;
}

static CameraFault reason(vec3 eye, Corners v)
{
    return reason_but(CAMERA_OK, eye, v);
}

static CameraFault always_right_handed(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.right = vec3_cross(c.forward, c.up);
    return store(reason(eye, v), c, camera);
}

static CameraFault always_left_handed(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.right = vec3_cross(c.up, c.forward);
    return store(reason(eye, v), c, camera);
}

static CameraFault right_for_left(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.right = -c.right;
    return store(reason(eye, v), c, camera);
}

static CameraFault down_for_up(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.up = -c.up;
    return store(reason(eye, v), c, camera);
}

static CameraFault behind_the_eye(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.forward = -c.forward;
    return store(reason(eye, v), c, camera);
}

static CameraFault right_and_up_swapped(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    vec3 right = c.right;
    c.right = c.up;
    c.up = right;
    return store(reason(eye, v), c, camera);
}

static CameraFault width_and_height_swapped(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    double width = c.width;
    c.width = c.height;
    c.height = width;
    return store(reason(eye, v), c, camera);
}

static CameraFault edges_not_unit(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.right *= c.width;
    c.up *= c.height;
    return store(reason(eye, v), c, camera);
}

static CameraFault forward_not_unit(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.forward *= c.distance;
    return store(reason(eye, v), c, camera);
}

static CameraFault half_of_width_and_height(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.width /= 2;
    c.height /= 2;
    return store(reason(eye, v), c, camera);
}

static CameraFault width_from_the_diagonal(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.width = vec3_length(v.lower_right - v.upper_left);
    return store(reason(eye, v), c, camera);
}

static CameraFault sum_for_the_middle(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.distance *= 4;
    return store(reason(eye, v), c, camera);
}

static CameraFault distance_to_a_corner(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.distance = vec3_length(v.upper_left);
    return store(reason(eye, v), c, camera);
}

static CameraFault forward_to_a_corner(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.forward = vec3_unit(v.upper_left);
    return store(reason(eye, v), c, camera);
}

static CameraFault distance_of_1(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.distance = 1;
    return store(reason(eye, v), c, camera);
}

static CameraFault plane_moved_to_distance_1(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.width /= c.distance;
    c.height /= c.distance;
    c.distance = 1;
    return store(reason(eye, v), c, camera);
}

static CameraFault eye_at_zero(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.origin = vec3_of(0, 0, 0);
    return store(reason(eye, v), c, camera);
}

static CameraFault vectors_taken_for_points(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    vec3 middle = c.distance * c.forward - eye;
    c.forward = vec3_unit(middle);
    c.distance = vec3_length(middle);
    return store(reason(eye, v), c, camera);
}

static CameraFault rounded_to_floats(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    for (int i = 0; i < 3; i++)
        c.forward[i] = (float)c.forward[i];
    return store(reason(eye, v), c, camera);
}

static CameraFault numbers_not_looked_at(vec3 eye, Corners v, Camera *camera)
{
    return store(reason_but(CAMERA_NOT_FINITE, eye, v), frame(eye, v), camera);
}

static CameraFault eye_not_looked_at(vec3 eye, Corners v, Camera *camera)
{
    return store(reason(vec3_of(0, 0, 0), v), frame(eye, v), camera);
}

static CameraFault rectangle_not_checked(vec3 eye, Corners v, Camera *camera)
{
    return store(reason_but(CAMERA_NO_RECTANGLE, eye, v), frame(eye, v), camera);
}

static CameraFault right_angle_not_checked(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    CameraFault fault = reason(eye, v);
    vec3 gap = v.upper_right - v.upper_left - (v.lower_right - v.lower_left);
    if (fault == CAMERA_NO_RECTANGLE && is_small(vec3_length(gap)))
        fault = CAMERA_OK;
    return store(fault, c, camera);
}

static CameraFault fourth_corner_not_checked(vec3 eye, Corners v, Camera *camera)
{
    v.lower_right = v.lower_left + v.upper_right - v.upper_left;
    return store(reason(eye, v), frame(eye, v), camera);
}

static CameraFault only_lengths_compared(vec3 eye, Corners v, Camera *camera)
{
    CameraFault fault = reason(eye, v);
    double top = vec3_length(v.upper_right - v.upper_left);
    double bottom = vec3_length(v.lower_right - v.lower_left);
    double left = vec3_length(v.upper_left - v.lower_left);
    double right = vec3_length(v.upper_right - v.lower_right);
    double falling = vec3_length(v.lower_right - v.upper_left);
    double rising = vec3_length(v.upper_right - v.lower_left);
    if (fault == CAMERA_NO_RECTANGLE && is_small(top - bottom) && is_small(left - right) &&
        is_small(falling - rising))
        fault = CAMERA_OK;
    return store(fault, frame(eye, v), camera);
}

static CameraFault axis_not_checked(vec3 eye, Corners v, Camera *camera)
{
    return store(reason_but(CAMERA_OFF_AXIS, eye, v), frame(eye, v), camera);
}

static CameraFault axis_checked_across_only(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    CameraFault fault = reason(eye, v);
    if (fault == CAMERA_OFF_AXIS && is_small(vec3_dot(c.right, c.forward)))
        fault = CAMERA_OK;
    return store(fault, c, camera);
}

static CameraFault axis_checked_upward_only(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    CameraFault fault = reason(eye, v);
    if (fault == CAMERA_OFF_AXIS && is_small(vec3_dot(c.up, c.forward)))
        fault = CAMERA_OK;
    return store(fault, c, camera);
}

static CameraFault one_percent_is_good_enough(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    CameraFault fault = reason(eye, v);
    if ((fault == CAMERA_NO_RECTANGLE || fault == CAMERA_OFF_AXIS) &&
        fabs(vec3_dot(c.right, c.up)) < 0.01 && fabs(vec3_dot(c.right, c.forward)) < 0.01)
        fault = CAMERA_OK;
    return store(fault, c, camera);
}

static CameraFault compared_exactly(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    CameraFault fault = reason(eye, v);
    if (fault == CAMERA_OK && vec3_dot(c.right, c.up) != 0)
        fault = CAMERA_NO_RECTANGLE;
    return store(fault, c, camera);
}

static CameraFault other_hand_refused(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    CameraFault fault = reason(eye, v);
    if (fault == CAMERA_OK && vec3_dot(vec3_cross(c.right, c.up), c.forward) > 0)
        fault = CAMERA_NO_RECTANGLE;
    return store(fault, c, camera);
}

static CameraFault no_distance_not_noticed(vec3 eye, Corners v, Camera *camera)
{
    return store(reason_but(CAMERA_NO_DISTANCE, eye, v), frame(eye, v), camera);
}

static CameraFault no_width_not_noticed(vec3 eye, Corners v, Camera *camera)
{
    return store(reason_but(CAMERA_NO_WIDTH, eye, v), frame(eye, v), camera);
}

static CameraFault no_height_not_noticed(vec3 eye, Corners v, Camera *camera)
{
    return store(reason_but(CAMERA_NO_HEIGHT, eye, v), frame(eye, v), camera);
}

static CameraFault one_reason_for_all(vec3 eye, Corners v, Camera *camera)
{
    CameraFault fault = reason(eye, v);
    return store(fault == CAMERA_OK ? CAMERA_OK : CAMERA_NO_RECTANGLE, frame(eye, v), camera);
}

static CameraFault reason_of_the_frame(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    CameraFault fault = reason(eye, v);
    return store(fault == CAMERA_OK ? CAMERA_OK : camera_check(c), c, camera);
}

static CameraFault stored_before_it_is_checked(vec3 eye, Corners v, Camera *camera)
{
    *camera = frame(eye, v);
    return reason(eye, v);
}

static CameraFault emptied_on_refusal(vec3 eye, Corners v, Camera *camera)
{
    *camera = (Camera){.distance = 0};
    return store(reason(eye, v), frame(eye, v), camera);
}

static CameraFault never_stored(vec3 eye, Corners v, Camera *camera)
{
    (void)camera;
    return reason(eye, v);
}

// ---- eye and four points ----------------------------------------------------------------------

static Corners moved(Corners corners, vec3 by)
{
    return (Corners){corners.upper_left + by, corners.upper_right + by, corners.lower_left + by,
                     corners.lower_right + by};
}

static CameraFault points_taken_for_vectors(vec3 eye, Corners points, Camera *camera)
{
    return camera_from_vectors(eye, points, camera);
}

static CameraFault eye_added(vec3 eye, Corners points, Camera *camera)
{
    return camera_from_vectors(eye, moved(points, eye), camera);
}

static CameraFault from_points_to_the_eye(vec3 eye, Corners p, Camera *camera)
{
    Corners v = {eye - p.upper_left, eye - p.upper_right, eye - p.lower_left, eye - p.lower_right};
    return camera_from_vectors(eye, v, camera);
}

static CameraFault eye_forgotten(vec3 eye, Corners points, Camera *camera)
{
    return camera_from_vectors(vec3_of(0, 0, 0), moved(points, -eye), camera);
}

static CameraFault taken_in_a_circle(vec3 eye, Corners p, Camera *camera)
{
    Corners v = moved((Corners){p.upper_left, p.upper_right, p.lower_right, p.lower_left}, -eye);
    return camera_from_vectors(eye, v, camera);
}

static CameraFault lower_ones_first(vec3 eye, Corners p, Camera *camera)
{
    Corners v = moved((Corners){p.lower_left, p.lower_right, p.upper_left, p.upper_right}, -eye);
    return camera_from_vectors(eye, v, camera);
}

static CameraFault right_ones_first(vec3 eye, Corners p, Camera *camera)
{
    Corners v = moved((Corners){p.upper_right, p.upper_left, p.lower_right, p.lower_left}, -eye);
    return camera_from_vectors(eye, v, camera);
}

static CameraFault one_corner_not_moved(vec3 eye, Corners points, Camera *camera)
{
    Corners v = moved(points, -eye);
    v.lower_right = points.lower_right;
    return camera_from_vectors(eye, v, camera);
}

static CameraFault rectangle_of_points_not_checked(vec3 eye, Corners points, Camera *camera)
{
    Corners v = moved(points, -eye);
    return store(reason_but(CAMERA_NO_RECTANGLE, eye, v), frame(eye, v), camera);
}

static CameraFault axis_of_points_not_checked(vec3 eye, Corners points, Camera *camera)
{
    Corners v = moved(points, -eye);
    return store(reason_but(CAMERA_OFF_AXIS, eye, v), frame(eye, v), camera);
}

static CameraFault no_distance_of_points(vec3 eye, Corners points, Camera *camera)
{
    Corners v = moved(points, -eye);
    return store(reason_but(CAMERA_NO_DISTANCE, eye, v), frame(eye, v), camera);
}

static CameraFault points_not_looked_at(vec3 eye, Corners points, Camera *camera)
{
    Corners v = moved(points, -eye);
    return store(reason_but(CAMERA_NOT_FINITE, eye, v), frame(eye, v), camera);
}

static CameraFault points_stored_unchecked(vec3 eye, Corners points, Camera *camera)
{
    Corners v = moved(points, -eye);
    *camera = frame(eye, v);
    return reason(eye, v);
}

static CameraFault reason_of_points_dropped(vec3 eye, Corners points, Camera *camera)
{
    camera_from_vectors(eye, moved(points, -eye), camera);
    return CAMERA_OK;
}

// ---- eye, lower left corner, two vectors ------------------------------------------------------

// A rectangle from its lower left corner, as a vector from the eye.
static Corners spanned(vec3 corner, vec3 across, vec3 up)
{
    return (Corners){corner + up, corner + up + across, corner, corner + across};
}

static CameraFault corner_taken_for_a_vector(vec3 eye, vec3 corner, vec3 across, vec3 up,
                                             Camera *camera)
{
    return camera_from_vectors(eye, spanned(corner, across, up), camera);
}

static CameraFault corner_taken_for_the_upper_left(vec3 eye, vec3 corner, vec3 across, vec3 up,
                                                   Camera *camera)
{
    return camera_from_vectors(eye, spanned(corner - eye - up, across, up), camera);
}

static CameraFault corner_taken_for_the_middle(vec3 eye, vec3 corner, vec3 across, vec3 up,
                                               Camera *camera)
{
    vec3 lower_left = corner - eye - across / 2 - up / 2;
    return camera_from_vectors(eye, spanned(lower_left, across, up), camera);
}

static CameraFault across_and_up_swapped(vec3 eye, vec3 corner, vec3 across, vec3 up,
                                         Camera *camera)
{
    return camera_from_vectors(eye, spanned(corner - eye, up, across), camera);
}

static CameraFault vectors_taken_for_corners(vec3 eye, vec3 corner, vec3 across, vec3 up,
                                             Camera *camera)
{
    Corners p = {up, across + up - corner, corner, across};
    return camera_from_points(eye, p, camera);
}

// From forward and up, as in a look-at, and for one hand.
static CameraFault right_worked_out(vec3 eye, vec3 corner, vec3 across, vec3 up, Camera *camera)
{
    Camera c = {.distance = 0};
    CameraFault fault = camera_from_vectors(eye, spanned(corner - eye, across, up), &c);
    c.right = vec3_cross(c.up, c.forward);
    return store(fault, c, camera);
}

static CameraFault height_of_the_width(vec3 eye, vec3 corner, vec3 across, vec3 up, Camera *camera)
{
    Camera c = {.distance = 0};
    CameraFault fault = camera_from_vectors(eye, spanned(corner - eye, across, up), &c);
    c.height = c.width;
    return store(fault, c, camera);
}

static CameraFault right_angle_of_edges_not_checked(vec3 eye, vec3 corner, vec3 across, vec3 up,
                                                    Camera *camera)
{
    Corners v = spanned(corner - eye, across, up);
    return store(reason_but(CAMERA_NO_RECTANGLE, eye, v), frame(eye, v), camera);
}

static CameraFault up_made_perpendicular(vec3 eye, vec3 corner, vec3 across, vec3 up,
                                         Camera *camera)
{
    Corners v = spanned(corner - eye, across, up);
    CameraFault fault = reason_but(CAMERA_NO_RECTANGLE, eye, v);
    Camera c = frame(eye, v);
    c.up = vec3_unit(c.up - vec3_dot(c.up, c.right) * c.right);
    return store(fault, c, camera);
}

static CameraFault axis_of_edges_not_checked(vec3 eye, vec3 corner, vec3 across, vec3 up,
                                             Camera *camera)
{
    Corners v = spanned(corner - eye, across, up);
    return store(reason_but(CAMERA_OFF_AXIS, eye, v), frame(eye, v), camera);
}

static CameraFault no_edges_not_noticed(vec3 eye, vec3 corner, vec3 across, vec3 up, Camera *camera)
{
    Corners v = spanned(corner - eye, across, up);
    return store(reason_but(CAMERA_NO_HEIGHT, eye, v), frame(eye, v), camera);
}

static CameraFault edges_not_looked_at(vec3 eye, vec3 corner, vec3 across, vec3 up, Camera *camera)
{
    Corners v = spanned(corner - eye, across, up);
    return store(reason_but(CAMERA_NOT_FINITE, eye, v), frame(eye, v), camera);
}

static CameraFault edges_stored_unchecked(vec3 eye, vec3 corner, vec3 across, vec3 up,
                                          Camera *camera)
{
    Corners v = spanned(corner - eye, across, up);
    *camera = frame(eye, v);
    return reason(eye, v);
}

// ---- look-at ----------------------------------------------------------------------------------

static Camera seen(LookAt view, Handedness world)
{
    vec3 forward = vec3_unit(view.at - view.eye);
    vec3 right = vec3_unit(world == RIGHT_HANDED ? vec3_cross(forward, view.up)
                                                 : vec3_cross(view.up, forward));
    vec3 up = vec3_unit(view.up - vec3_dot(view.up, forward) * forward);
    return (Camera){.origin = view.eye,
                    .right = right,
                    .up = up,
                    .forward = forward,
                    .distance = vec3_length(view.at - view.eye),
                    .width = view.width,
                    .height = view.width / view.aspect};
}

// The first reason, but for one that is forgotten.
static CameraFault view_reason_but(CameraFault forgotten, LookAt view)
{
    vec3 ahead = view.at - view.eye, sideways = vec3_cross(ahead, view.up);
    double length = vec3_length(ahead), up_length = vec3_length(view.up);
    if (forgotten != CAMERA_NOT_FINITE &&
        !(isfinite(length) && isfinite(up_length) && isfinite(view.width) && isfinite(view.aspect)))
        return CAMERA_NOT_FINITE;
    if (forgotten != CAMERA_NO_DIRECTION && length == 0)
        return CAMERA_NO_DIRECTION;
    if (forgotten != CAMERA_UP_ALONG_VIEW &&
        vec3_length(sideways) <= CAMERA_TOLERANCE * length * up_length)
        return CAMERA_UP_ALONG_VIEW;
    if (forgotten != CAMERA_NO_WIDTH && view.width <= 0)
        return CAMERA_NO_WIDTH;
    if (forgotten != CAMERA_NO_HEIGHT && view.aspect <= 0)
        return CAMERA_NO_HEIGHT;
    return CAMERA_OK;
}

static CameraFault view_reason(LookAt view)
{
    return view_reason_but(CAMERA_OK, view);
}

static CameraFault forward_to_the_eye(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.forward = -c.forward;
    c.right = -c.right; // it follows from the cross product
    return store(view_reason(view), c, camera);
}

static CameraFault only_forward_turned_round(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.forward = -c.forward;
    return store(view_reason(view), c, camera);
}

static CameraFault cross_the_other_way_round(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.right = -c.right;
    return store(view_reason(view), c, camera);
}

static CameraFault look_always_right_handed(LookAt view, Handedness world, Camera *camera)
{
    (void)world;
    return store(view_reason(view), seen(view, RIGHT_HANDED), camera);
}

static CameraFault look_always_left_handed(LookAt view, Handedness world, Camera *camera)
{
    (void)world;
    return store(view_reason(view), seen(view, LEFT_HANDED), camera);
}

static CameraFault upside_down(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.up = -c.up;
    return store(view_reason(view), c, camera);
}

// right x forward, whatever the world: right in one, upside down in the other.
static CameraFault up_of_one_world(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.up = vec3_cross(c.right, c.forward);
    return store(view_reason(view), c, camera);
}

static CameraFault up_as_given(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.up = view.up;
    return store(view_reason(view), c, camera);
}

static CameraFault up_only_made_unit(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.up = vec3_unit(view.up);
    return store(view_reason(view), c, camera);
}

static CameraFault right_not_unit(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.right = world == RIGHT_HANDED ? vec3_cross(c.forward, vec3_unit(view.up))
                                    : vec3_cross(vec3_unit(view.up), c.forward);
    return store(view_reason(view), c, camera);
}

static CameraFault right_and_up_not_unit(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    double length = vec3_length(vec3_cross(c.forward, view.up));
    c.right *= length;
    c.up *= length;
    return store(view_reason(view), c, camera);
}

static CameraFault view_not_unit(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.forward = view.at - view.eye;
    return store(view_reason(view), c, camera);
}

static CameraFault aspect_upside_down(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.height = view.width * view.aspect;
    return store(view_reason(view), c, camera);
}

static CameraFault aspect_ignored(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.height = view.width;
    return store(view_reason(view), c, camera);
}

static CameraFault width_taken_for_height(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.width = view.width * view.aspect;
    c.height = view.width;
    return store(view_reason(view), c, camera);
}

static CameraFault look_distance_of_1(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.distance = 1;
    return store(view_reason(view), c, camera);
}

static CameraFault distance_squared(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.distance = vec3_dot(view.at - view.eye, view.at - view.eye);
    return store(view_reason(view), c, camera);
}

static CameraFault eye_where_it_looks(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.origin = view.at;
    return store(view_reason(view), c, camera);
}

static CameraFault at_taken_for_a_direction(LookAt view, Handedness world, Camera *camera)
{
    CameraFault fault = view_reason(view);
    view.at += view.eye;
    return store(fault, seen(view, world), camera);
}

static CameraFault up_along_view_not_noticed(LookAt view, Handedness world, Camera *camera)
{
    return store(view_reason_but(CAMERA_UP_ALONG_VIEW, view), seen(view, world), camera);
}

static CameraFault up_of_zero_not_noticed(LookAt view, Handedness world, Camera *camera)
{
    CameraFault fault = view_reason(view);
    return store(vec3_length(view.up) == 0 ? CAMERA_OK : fault, seen(view, world), camera);
}

static CameraFault up_along_view_by_dot(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    CameraFault fault = view_reason(view);
    if (fault == CAMERA_UP_ALONG_VIEW && vec3_dot(view.up, c.forward) < 0)
        fault = CAMERA_OK;
    return store(fault, c, camera);
}

static CameraFault up_compared_exactly(LookAt view, Handedness world, Camera *camera)
{
    CameraFault fault = view_reason_but(CAMERA_UP_ALONG_VIEW, view);
    if (fault == CAMERA_OK && vec3_length(vec3_cross(view.at - view.eye, view.up)) == 0)
        fault = CAMERA_UP_ALONG_VIEW;
    return store(fault, seen(view, world), camera);
}

static CameraFault leaning_up_refused(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    CameraFault fault = view_reason(view);
    if (fault == CAMERA_OK && fabs(vec3_dot(vec3_unit(view.up), c.forward)) > 0.99)
        fault = CAMERA_UP_ALONG_VIEW;
    return store(fault, c, camera);
}

static CameraFault no_direction_not_noticed(LookAt view, Handedness world, Camera *camera)
{
    CameraFault fault = view_reason(view);
    Camera c = seen(view, world);
    return store(fault == CAMERA_NO_DIRECTION ? CAMERA_OK : fault, c, camera);
}

static CameraFault no_direction_called_up(LookAt view, Handedness world, Camera *camera)
{
    return store(view_reason_but(CAMERA_NO_DIRECTION, view), seen(view, world), camera);
}

static CameraFault look_no_width_not_noticed(LookAt view, Handedness world, Camera *camera)
{
    return store(view_reason_but(CAMERA_NO_WIDTH, view), seen(view, world), camera);
}

static CameraFault aspect_not_checked(LookAt view, Handedness world, Camera *camera)
{
    return store(view_reason_but(CAMERA_NO_HEIGHT, view), seen(view, world), camera);
}

static CameraFault negative_width_made_positive(LookAt view, Handedness world, Camera *camera)
{
    view.width = fabs(view.width);
    return store(view_reason(view), seen(view, world), camera);
}

static CameraFault negative_aspect_made_positive(LookAt view, Handedness world, Camera *camera)
{
    view.aspect = fabs(view.aspect);
    return store(view_reason(view), seen(view, world), camera);
}

static CameraFault view_not_looked_at(LookAt view, Handedness world, Camera *camera)
{
    return store(view_reason_but(CAMERA_NOT_FINITE, view), seen(view, world), camera);
}

static CameraFault only_vectors_looked_at(LookAt view, Handedness world, Camera *camera)
{
    CameraFault fault = view_reason(view);
    if (!isfinite(view.width) || !isfinite(view.aspect))
        fault = CAMERA_OK;
    return store(fault, seen(view, world), camera);
}

static CameraFault look_stored_unchecked(LookAt view, Handedness world, Camera *camera)
{
    *camera = seen(view, world);
    return view_reason(view);
}

// ---- width from angle -------------------------------------------------------------------------

static double whole_angle(double degrees, double distance)
{
    return 2 * distance * tan(degrees * PI / 180);
}

static double degrees_into_tan(double degrees, double distance)
{
    return 2 * distance * tan(degrees / 2);
}

static double half_the_width(double degrees, double distance)
{
    return distance * tan(degrees * PI / 360);
}

static double tangent_of_the_whole_angle(double degrees, double distance)
{
    return distance * tan(degrees * PI / 180);
}

static double distance_forgotten(double degrees, double distance)
{
    (void)distance;
    return 2 * tan(degrees * PI / 360);
}

static double divided_by_the_distance(double degrees, double distance)
{
    return 2 * tan(degrees * PI / 360) / distance;
}

static double length_of_the_arc(double degrees, double distance)
{
    return distance * degrees * PI / 180;
}

static double chord_for_tangent(double degrees, double distance)
{
    return 2 * distance * sin(degrees * PI / 360);
}

static double divided_by_the_tangent(double degrees, double distance)
{
    return 2 * distance / tan(degrees * PI / 360);
}

static double pi_in_three_digits(double degrees, double distance)
{
    return 2 * distance * tan(degrees * 3.14 / 360);
}

static double whole_degrees_halved(double degrees, double distance)
{
    return 2 * distance * tan((int)degrees / 2 * PI / 180);
}

const Mistake mistakes[] = {
    MISTAKE("V-right-handed", camera_from_vectors, always_right_handed, "right = f x u, always"),
    MISTAKE("V-left-handed", camera_from_vectors, always_left_handed, "right = u x f, always"),
    MISTAKE("V-mirror", camera_from_vectors, right_for_left, "the sign of r"),
    MISTAKE("V-down", camera_from_vectors, down_for_up, "the sign of u"),
    MISTAKE("V-behind", camera_from_vectors, behind_the_eye, "the sign of f"),
    MISTAKE("V-swap", camera_from_vectors, right_and_up_swapped, "r and u swapped"),
    MISTAKE("V-sizes", camera_from_vectors, width_and_height_swapped, "w and h swapped"),
    MISTAKE("V-edges", camera_from_vectors, edges_not_unit, "r and u not unit"),
    MISTAKE("V-forward", camera_from_vectors, forward_not_unit, "f not unit"),
    MISTAKE("V-half", camera_from_vectors, half_of_width_and_height, "half of w and of h"),
    MISTAKE("V-diagonal", camera_from_vectors, width_from_the_diagonal, "w from the diagonal"),
    MISTAKE("V-sum", camera_from_vectors, sum_for_the_middle, "the sum of four, not their middle"),
    MISTAKE("V-far", camera_from_vectors, distance_to_a_corner, "d to a corner"),
    MISTAKE("V-corner", camera_from_vectors, forward_to_a_corner, "f towards a corner"),
    MISTAKE("V-1", camera_from_vectors, distance_of_1, "d = 1, w and h as they are"),
    MISTAKE("V-1-all", camera_from_vectors, plane_moved_to_distance_1, "the plane at d = 1"),
    MISTAKE("V-eye", camera_from_vectors, eye_at_zero, "the eye not stored"),
    MISTAKE("V-points", camera_from_vectors, vectors_taken_for_points, "the eye subtracted"),
    MISTAKE("V-float", camera_from_vectors, rounded_to_floats, "f in single precision"),
    MISTAKE("V-nan", camera_from_vectors, numbers_not_looked_at, "NaN and infinity let through"),
    MISTAKE("V-nan-eye", camera_from_vectors, eye_not_looked_at, "a NaN in the eye let through"),
    MISTAKE("V-any", camera_from_vectors, rectangle_not_checked, "any four corners will do"),
    MISTAKE("V-lean", camera_from_vectors, right_angle_not_checked, "a parallelogram will do"),
    MISTAKE("V-three", camera_from_vectors, fourth_corner_not_checked, "three corners looked at"),
    MISTAKE("V-lengths", camera_from_vectors, only_lengths_compared, "edges compared by length"),
    MISTAKE("V-axis", camera_from_vectors, axis_not_checked, "eye anywhere"),
    MISTAKE("V-axis-u", camera_from_vectors, axis_checked_across_only, "u . f not looked at"),
    MISTAKE("V-axis-r", camera_from_vectors, axis_checked_upward_only, "r . f not looked at"),
    MISTAKE("V-loose", camera_from_vectors, one_percent_is_good_enough, "right angles to 1%"),
    MISTAKE("V-exact", camera_from_vectors, compared_exactly, "no room for rounding"),
    MISTAKE("V-hand", camera_from_vectors, other_hand_refused, "left-handed frames refused"),
    MISTAKE("V-d", camera_from_vectors, no_distance_not_noticed, "d = 0 not noticed"),
    MISTAKE("V-w", camera_from_vectors, no_width_not_noticed, "w = 0 not noticed"),
    MISTAKE("V-h", camera_from_vectors, no_height_not_noticed, "h = 0 not noticed"),
    MISTAKE("V-reason", camera_from_vectors, one_reason_for_all, "no rectangle, whatever it is"),
    MISTAKE("V-check", camera_from_vectors, reason_of_the_frame, "what camera_check says, only"),
    MISTAKE("V-store", camera_from_vectors, stored_before_it_is_checked, "stored, then checked"),
    MISTAKE("V-empty", camera_from_vectors, emptied_on_refusal, "*camera emptied on refusal"),
    MISTAKE("V-never", camera_from_vectors, never_stored, "*camera never stored"),

    MISTAKE("F-vectors", camera_from_points, points_taken_for_vectors, "the eye not subtracted"),
    MISTAKE("F-plus", camera_from_points, eye_added, "the eye added"),
    MISTAKE("F-from", camera_from_points, from_points_to_the_eye, "eye - point"),
    MISTAKE("F-eye", camera_from_points, eye_forgotten, "the eye not stored"),
    MISTAKE("F-circle", camera_from_points, taken_in_a_circle, "corners taken in a circle"),
    MISTAKE("F-lower", camera_from_points, lower_ones_first, "upper and lower swapped"),
    MISTAKE("F-right", camera_from_points, right_ones_first, "left and right swapped"),
    MISTAKE("F-one", camera_from_points, one_corner_not_moved, "eye subtracted from three"),
    MISTAKE("F-any", camera_from_points, rectangle_of_points_not_checked, "any corners will do"),
    MISTAKE("F-axis", camera_from_points, axis_of_points_not_checked, "eye anywhere"),
    MISTAKE("F-d", camera_from_points, no_distance_of_points, "d = 0 not noticed"),
    MISTAKE("F-nan", camera_from_points, points_not_looked_at, "NaN and infinity let through"),
    MISTAKE("F-store", camera_from_points, points_stored_unchecked, "stored, then checked"),
    MISTAKE("F-ok", camera_from_points, reason_of_points_dropped, "the reason not passed on"),

    MISTAKE("K-vector", camera_from_corner, corner_taken_for_a_vector, "the eye not subtracted"),
    MISTAKE("K-upper", camera_from_corner, corner_taken_for_the_upper_left, "as if upper left"),
    MISTAKE("K-middle", camera_from_corner, corner_taken_for_the_middle, "as if the middle"),
    MISTAKE("K-swap", camera_from_corner, across_and_up_swapped, "across and up swapped"),
    MISTAKE("K-corners", camera_from_corner, vectors_taken_for_corners, "vectors as points"),
    MISTAKE("K-hand", camera_from_corner, right_worked_out, "right = u x f, not across"),
    MISTAKE("K-square", camera_from_corner, height_of_the_width, "h = w"),
    MISTAKE("K-lean", camera_from_corner, right_angle_of_edges_not_checked, "any two vectors do"),
    MISTAKE("K-straight", camera_from_corner, up_made_perpendicular, "up put right, not refused"),
    MISTAKE("K-axis", camera_from_corner, axis_of_edges_not_checked, "eye anywhere"),
    MISTAKE("K-h", camera_from_corner, no_edges_not_noticed, "h = 0 not noticed"),
    MISTAKE("K-nan", camera_from_corner, edges_not_looked_at, "NaN and infinity let through"),
    MISTAKE("K-store", camera_from_corner, edges_stored_unchecked, "stored, then checked"),

    MISTAKE("L1", camera_from_look_at, forward_to_the_eye, "forward = eye - at"),
    MISTAKE("L1-only", camera_from_look_at, only_forward_turned_round, "the sign of forward"),
    MISTAKE("L2", camera_from_look_at, cross_the_other_way_round, "cross the other way round"),
    MISTAKE("L2-right", camera_from_look_at, look_always_right_handed, "always right-handed"),
    MISTAKE("L2-left", camera_from_look_at, look_always_left_handed, "always left-handed"),
    MISTAKE("L2-down", camera_from_look_at, upside_down, "up the other way round"),
    MISTAKE("L2-up", camera_from_look_at, up_of_one_world, "up = r x f in either world"),
    MISTAKE("L3", camera_from_look_at, up_as_given, "up as given"),
    MISTAKE("L3-unit", camera_from_look_at, up_only_made_unit, "up unit, not perpendicular"),
    MISTAKE("L4", camera_from_look_at, right_not_unit, "right not unit where up leans"),
    MISTAKE("L4-up", camera_from_look_at, right_and_up_not_unit, "right and up not unit"),
    MISTAKE("L4-forward", camera_from_look_at, view_not_unit, "forward not unit"),
    MISTAKE("L10", camera_from_look_at, aspect_upside_down, "height = width aspect"),
    MISTAKE("L11", camera_from_look_at, aspect_ignored, "height = width"),
    MISTAKE("L11-width", camera_from_look_at, width_taken_for_height, "width taken for height"),
    MISTAKE("L12", camera_from_look_at, up_along_view_not_noticed, "up along the view"),
    MISTAKE("L12-zero", camera_from_look_at, up_of_zero_not_noticed, "up of zero not noticed"),
    MISTAKE("L12-dot", camera_from_look_at, up_along_view_by_dot, "up against the view missed"),
    MISTAKE("L12-exact", camera_from_look_at, up_compared_exactly, "cross compared with 0"),
    MISTAKE("L12-lean", camera_from_look_at, leaning_up_refused, "an up that leans is refused"),
    MISTAKE("L-1", camera_from_look_at, look_distance_of_1, "d = 1"),
    MISTAKE("L-squared", camera_from_look_at, distance_squared, "the square root forgotten"),
    MISTAKE("L-at", camera_from_look_at, eye_where_it_looks, "the eye at the point looked at"),
    MISTAKE("L-direction", camera_from_look_at, at_taken_for_a_direction, "at as a direction"),
    MISTAKE("L-eye", camera_from_look_at, no_direction_not_noticed, "at = eye not noticed"),
    MISTAKE("L-eye-up", camera_from_look_at, no_direction_called_up, "at = eye put down to up"),
    MISTAKE("L-w", camera_from_look_at, look_no_width_not_noticed, "width not looked at"),
    MISTAKE("L-h", camera_from_look_at, aspect_not_checked, "aspect not looked at"),
    MISTAKE("L-w-minus", camera_from_look_at, negative_width_made_positive, "|width|"),
    MISTAKE("L-h-minus", camera_from_look_at, negative_aspect_made_positive, "|aspect|"),
    MISTAKE("L-nan", camera_from_look_at, view_not_looked_at, "NaN and infinity let through"),
    MISTAKE("L-nan-size", camera_from_look_at, only_vectors_looked_at, "NaN width let through"),
    MISTAKE("L-store", camera_from_look_at, look_stored_unchecked, "stored, then checked"),

    MISTAKE("L6", width_from_angle, whole_angle, "tan(angle), not tan(angle / 2)"),
    MISTAKE("L7", width_from_angle, degrees_into_tan, "degrees into tan"),
    MISTAKE("L6-half", width_from_angle, half_the_width, "half the width"),
    MISTAKE("L6-once", width_from_angle, tangent_of_the_whole_angle, "d tan(angle)"),
    MISTAKE("A-distance", width_from_angle, distance_forgotten, "the distance forgotten"),
    MISTAKE("A-divided", width_from_angle, divided_by_the_distance, "divided by the distance"),
    MISTAKE("A-arc", width_from_angle, length_of_the_arc, "the arc, not the line"),
    MISTAKE("A-chord", width_from_angle, chord_for_tangent, "sine for tangent"),
    MISTAKE("A-cotangent", width_from_angle, divided_by_the_tangent, "divided by the tangent"),
    MISTAKE("A-pi", width_from_angle, pi_in_three_digits, "3.14 for pi"),
    MISTAKE("A-whole", width_from_angle, whole_degrees_halved, "degrees halved as an integer"),
    {0},
};
