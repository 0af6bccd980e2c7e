// right.c - right answers to exercise 02, written in other ways.
#include "exercises/02-cameras.h"

#include "tests/judge/known.h"

static CameraFault give(Camera found, Camera *camera)
{
    CameraFault fault = camera_check(found);
    if (fault == CAMERA_OK)
        *camera = found;
    return fault;
}

static bool at_right_angles(vec3 v, vec3 w)
{
    return fabs(vec3_dot(v, w)) <= CAMERA_TOLERANCE * vec3_length(v) * vec3_length(w);
}

// ---- rectangles -------------------------------------------------------------------------------

// The middle between two opposite corners; if the other two have the same middle, it is a
// parallelogram.
static CameraFault by_diagonals(vec3 eye, Corners points, Camera *camera)
{
    vec3 middle = (points.lower_left + points.upper_right) / 2;
    vec3 other = (points.lower_right + points.upper_left) / 2;
    vec3 across = points.lower_right - points.lower_left;
    vec3 up = points.upper_right - points.lower_right;
    double d = vec3_length(middle - eye), w = vec3_length(across), h = vec3_length(up);
    if (!isfinite(d + w + h + vec3_length(other)))
        return CAMERA_NOT_FINITE;
    if (vec3_length(middle - other) > CAMERA_TOLERANCE * (w + h))
        return CAMERA_NO_RECTANGLE;
    if (h == 0)
        return CAMERA_NO_HEIGHT;
    if (w == 0)
        return CAMERA_NO_WIDTH;
    if (d == 0)
        return CAMERA_NO_DISTANCE;
    if (!at_right_angles(across, up))
        return CAMERA_NO_RECTANGLE;
    if (!at_right_angles(across, middle - eye) || !at_right_angles(up, middle - eye))
        return CAMERA_OFF_AXIS;
    return give((Camera){eye, across / w, up / h, (middle - eye) / d, d, w, h}, camera);
}

// Comparisons that are false for NaN: corners that are not finite, or coincide, do not make a
// rectangle.
static bool unit_at_right_angles(vec3 v, vec3 w)
{
    return fabs(vec3_dot(vec3_unit(v), vec3_unit(w))) <= CAMERA_TOLERANCE;
}

static CameraFault no_rectangle_first(vec3 eye, Corners v, Camera *camera)
{
    vec3 across = v.lower_right - v.lower_left, up = v.upper_left - v.lower_left;
    vec3 gap = v.upper_right - v.lower_right - up, middle = (v.lower_left + v.upper_right) / 2;
    double w = vec3_length(across), h = vec3_length(up), d = vec3_length(middle);
    if (!(vec3_length(gap) <= CAMERA_TOLERANCE * (w + h)) || !unit_at_right_angles(across, up))
        return CAMERA_NO_RECTANGLE;
    if (!unit_at_right_angles(across, middle) || !unit_at_right_angles(up, middle))
        return CAMERA_OFF_AXIS;
    return give((Camera){eye, across / w, up / h, middle / d, d, w, h}, camera);
}

static CameraFault halfway_from_the_corner(vec3 eye, vec3 lower_left, vec3 across, vec3 up,
                                           Camera *camera)
{
    vec3 middle = lower_left + 0.5 * across + 0.5 * up - eye;
    Camera c = {.origin = eye, .distance = vec3_length(middle)};
    c.right = vec3_unit(across);
    c.up = vec3_unit(up);
    c.forward = vec3_unit(middle);
    c.width = vec3_length(across);
    c.height = vec3_length(up);
    if (!vec3_is_finite(middle + across + up + eye))
        return CAMERA_NOT_FINITE;
    if (c.distance == 0)
        return CAMERA_NO_DISTANCE;
    if (c.width == 0 || c.height == 0)
        return c.height == 0 ? CAMERA_NO_HEIGHT : CAMERA_NO_WIDTH;
    if (fabs(vec3_dot(c.right, c.forward)) > CAMERA_TOLERANCE ||
        fabs(vec3_dot(c.up, c.forward)) > CAMERA_TOLERANCE)
        return fabs(vec3_dot(c.right, c.up)) > CAMERA_TOLERANCE ? CAMERA_NO_RECTANGLE
                                                                : CAMERA_OFF_AXIS;
    CameraFault fault = give(c, camera);
    return fault == CAMERA_NOT_PERPENDICULAR ? CAMERA_NO_RECTANGLE : fault;
}

typedef struct {
    vec3 way;
    double length;
} Measured;

static Measured measured(vec3 v)
{
    return (Measured){vec3_unit(v), vec3_length(v)};
}

RIGHT_LINE(camera_from_points, "points first; the middle from a diagonal",
           return by_diagonals(eye, points, camera))

RIGHT(camera_from_points, "neither NaN nor a line is a rectangle")
{
    Corners v = {points.upper_left - eye, points.upper_right - eye, points.lower_left - eye,
                 points.lower_right - eye};
    return no_rectangle_first(eye, v, camera);
}

RIGHT(camera_from_points, "a corner and two edges, and the fourth corner")
{
    vec3 across = points.lower_right - points.lower_left,
         up = points.upper_left - points.lower_left;
    vec3 gap = points.upper_right - (points.lower_left + across + up);
    double size = vec3_length(across) + vec3_length(up);
    if (!vec3_is_finite(points.upper_right))
        return CAMERA_NOT_FINITE;
    if (size > 0 && vec3_length(gap) > CAMERA_TOLERANCE * size)
        return CAMERA_NO_RECTANGLE;
    return halfway_from_the_corner(eye, points.lower_left, across, up, camera);
}

RIGHT(camera_from_vectors, "as points, seen from the origin")
{
    if (!vec3_is_finite(eye))
        return CAMERA_NOT_FINITE;
    Camera c;
    CameraFault fault = by_diagonals(vec3_of(0, 0, 0), vectors, &c);
    if (fault == CAMERA_OK) {
        *camera = c;
        camera->origin = eye;
    }
    return fault;
}

RIGHT(camera_from_vectors, "turned into points, and back")
{
    Corners points = {eye + vectors.upper_left, eye + vectors.upper_right, eye + vectors.lower_left,
                      eye + vectors.lower_right};
    return by_diagonals(eye, points, camera);
}

// Forward is the normal, and d how far the plane is along it: this needs no mean.
RIGHT(camera_from_vectors, "forward and d along the normal; four angles")
{
    Corners v = vectors;
    vec3 top = v.upper_right - v.upper_left, right = v.upper_right - v.lower_right;
    vec3 bottom = v.lower_right - v.lower_left, left = v.upper_left - v.lower_left;
    if (!vec3_is_finite(eye + v.upper_left) || !isfinite(vec3_length(top) + vec3_length(bottom)))
        return CAMERA_NOT_FINITE;
    if (vec3_length(top) == 0 || vec3_length(bottom) == 0)
        return CAMERA_NO_WIDTH;
    if (vec3_length(left) == 0 || vec3_length(right) == 0)
        return CAMERA_NO_HEIGHT;
    // Four right angles make a rectangle, and it is flat.
    if (!at_right_angles(top, left) || !at_right_angles(top, right) ||
        !at_right_angles(bottom, left) || !at_right_angles(bottom, right))
        return CAMERA_NO_RECTANGLE;
    vec3 normal = vec3_unit(vec3_cross(top, left));
    double distance = vec3_dot(normal, v.lower_left);
    if (fabs(distance) <= 1e-15 * vec3_length(v.lower_left))
        return CAMERA_NO_DISTANCE;
    vec3 foot = distance * normal, middle = (v.lower_left + v.upper_right) / 2;
    if (vec3_length(middle - foot) > CAMERA_TOLERANCE * vec3_length(foot))
        return CAMERA_OFF_AXIS;
    return give((Camera){eye, vec3_unit(top), vec3_unit(left), foot / fabs(distance),
                         fabs(distance), vec3_length(top), vec3_length(left)},
                camera);
}

RIGHT_LINE(camera_from_vectors, "neither NaN nor a line is a rectangle",
           return no_rectangle_first(eye, vectors, camera))

// A parallelogram is one whose diagonals cross in their middles; a rectangle, if they are equal.
RIGHT(camera_from_vectors, "diagonals that are equal and halve each other")
{
    Corners v = vectors;
    vec3 falling = v.lower_right - v.upper_left, rising = v.upper_right - v.lower_left;
    vec3 apart = (v.upper_left + v.lower_right) / 2 - (v.upper_right + v.lower_left) / 2;
    vec3 right = v.upper_right - v.upper_left, up = v.upper_left - v.lower_left;
    vec3 middle = v.upper_left + falling / 2;
    double size = vec3_length(falling), d = vec3_length(middle);
    double w = vec3_length(right), h = vec3_length(up);
    if (!vec3_is_finite(eye) || !isfinite(size + vec3_length(rising) + d))
        return CAMERA_NOT_FINITE;
    if (w == 0 || h == 0)
        return w == 0 ? CAMERA_NO_WIDTH : CAMERA_NO_HEIGHT;
    if (d == 0)
        return CAMERA_NO_DISTANCE;
    // The difference of the diagonals is a length: compared with an edge, it is the cosine of the
    // angle.
    if (vec3_length(apart) > CAMERA_TOLERANCE * size ||
        fabs(vec3_dot(falling, falling) - vec3_dot(rising, rising)) > CAMERA_TOLERANCE * w * h)
        return CAMERA_NO_RECTANGLE;
    // And so do the vectors to opposite corners.
    if (!at_right_angles(middle, right) || !at_right_angles(middle, up))
        return CAMERA_OFF_AXIS;
    return give((Camera){eye, right / w, up / h, middle / d, d, w, h}, camera);
}

RIGHT(camera_from_corner, "neither NaN nor a line is a rectangle")
{
    vec3 v = lower_left - eye;
    return no_rectangle_first(eye, (Corners){v + up, v + up + across, v, v + across}, camera);
}

RIGHT_LINE(camera_from_corner, "half of each edge to the middle",
           return halfway_from_the_corner(eye, lower_left, across, up, camera))

RIGHT(camera_from_corner, "turned into points")
{
    Corners points = {lower_left + up, lower_left + up + across, lower_left, lower_left + across};
    return by_diagonals(eye, points, camera);
}

RIGHT(camera_from_corner, "a struct of direction and length, and loops")
{
    Measured right = measured(across), above = measured(up);
    Measured ahead = measured(lower_left + (across + up) / 2 - eye);
    const vec3 ways[] = {right.way, above.way, ahead.way};
    const double lengths[] = {right.length, above.length, ahead.length};
    const CameraFault faults[] = {CAMERA_NO_WIDTH, CAMERA_NO_HEIGHT, CAMERA_NO_DISTANCE};
    for (int i = 0; i < 3; i++)
        if (!isfinite(lengths[i]) || !vec3_is_finite(eye))
            return CAMERA_NOT_FINITE;
    for (int i = 0; i < 3; i++)
        if (lengths[i] == 0)
            return faults[i];
    for (int i = 0; i < 3; i++)
        if (fabs(vec3_dot(ways[i], ways[(i + 1) % 3])) > CAMERA_TOLERANCE)
            return i == 0 ? CAMERA_NO_RECTANGLE : CAMERA_OFF_AXIS;
    return give((Camera){eye, ways[0], ways[1], ways[2], lengths[2], lengths[0], lengths[1]},
                camera);
}

// ---- look-at ----------------------------------------------------------------------------------

// Gram and Schmidt: up without its part along forward, and right from both.
RIGHT(camera_from_look_at, "Gram and Schmidt; reasons in another order")
{
    vec3 ahead = view.at - view.eye;
    double d = vec3_length(ahead);
    if (!isfinite(d + vec3_length(view.up)))
        return CAMERA_NOT_FINITE;
    if (!(view.width > 0))
        return CAMERA_NO_WIDTH;
    if (!(view.aspect > 0))
        return CAMERA_NO_HEIGHT;
    if (d == 0)
        return CAMERA_NO_DIRECTION;
    vec3 f = ahead / d, up = view.up - vec3_dot(view.up, f) * f;
    if (vec3_length(up) <= CAMERA_TOLERANCE * vec3_length(view.up))
        return CAMERA_UP_ALONG_VIEW;
    up = vec3_unit(up);
    up = vec3_unit(up - vec3_dot(up, f) * f); // once more, against rounding
    vec3 r = world == RIGHT_HANDED ? vec3_cross(f, up) : vec3_cross(up, f);
    return give((Camera){view.eye, r, up, f, d, view.width, view.width / view.aspect}, camera);
}

// In a left-handed world right is on the other side, and everything else is the same.
RIGHT(camera_from_look_at, "one handedness, then mirrored; made first")
{
    Camera c = {.origin = view.eye, .width = view.width, .height = view.width / view.aspect};
    c.distance = vec3_length(view.at - view.eye);
    c.forward = (view.at - view.eye) / c.distance;
    c.right = vec3_cross(c.forward, vec3_unit(view.up));
    double sine = vec3_length(c.right);
    c.right /= world == RIGHT_HANDED ? sine : -sine;
    c.up = vec3_unit(vec3_cross(vec3_cross(c.forward, view.up), c.forward));
    if (!isfinite(c.distance) || !isfinite(vec3_length(view.up)))
        return CAMERA_NOT_FINITE;
    if (c.distance == 0)
        return CAMERA_NO_DIRECTION;
    if (vec3_length(view.up) == 0 || sine <= CAMERA_TOLERANCE)
        return CAMERA_UP_ALONG_VIEW;
    return view.aspect == 0 ? CAMERA_NO_HEIGHT : give(c, camera);
}

// Own checks only for faults that camera_check cannot know; it can know the distance.
RIGHT(camera_from_look_at, "the rest left to camera_check")
{
    vec3 f = vec3_unit(view.at - view.eye), unit_up = vec3_unit(view.up);
    double d = vec3_length(view.at - view.eye);
    if (d <= 0)
        return CAMERA_NO_DISTANCE;
    vec3 r = world == RIGHT_HANDED ? vec3_cross(f, unit_up) : vec3_cross(unit_up, f);
    if (vec3_length(view.up) == 0 || vec3_length(r) <= CAMERA_TOLERANCE)
        return CAMERA_UP_ALONG_VIEW;
    r = vec3_unit(r);
    vec3 u = world == RIGHT_HANDED ? vec3_cross(r, f) : vec3_cross(f, r);
    return give((Camera){view.eye, r, u, f, d, view.width, view.width / view.aspect}, camera);
}

// As in gluLookAt: z points backwards, x = up x z, y = z x x.
RIGHT(camera_from_look_at, "z backwards, x = up x z, y = z x x")
{
    vec3 back = view.eye - view.at;
    if (!vec3_is_finite(back) || !vec3_is_finite(view.up))
        return CAMERA_NOT_FINITE;
    double distance = vec3_length(back);
    if (distance == 0)
        return CAMERA_NO_DIRECTION;
    vec3 z = back / distance, x = vec3_cross(view.up, z);
    if (vec3_length(view.up) == 0 || vec3_length(x) / vec3_length(view.up) <= CAMERA_TOLERANCE)
        return CAMERA_UP_ALONG_VIEW;
    x = vec3_unit(x);
    vec3 y = vec3_cross(z, x);
    if (world == LEFT_HANDED)
        x = -x;
    if (!(view.width > 0) || !(view.aspect > 0) || !isfinite(view.aspect))
        return view.width > 0 ? CAMERA_NO_HEIGHT : CAMERA_NO_WIDTH;
    return give((Camera){view.eye, x, y, -z, distance, view.width, view.width / view.aspect},
                camera);
}

// ---- width from angle -------------------------------------------------------------------------

RIGHT(width_from_angle, "sine by cosine")
{
    double half = degrees * (PI / 360);
    return distance * sin(half) / cos(half) * 2;
}

// tan(a / 2) = sin a / (1 + cos a).
RIGHT(width_from_angle, "from the whole angle")
{
    double angle = degrees / 180 * PI;
    return 2 * distance * sin(angle) / (1 + cos(angle));
}

RIGHT_LINE(width_from_angle, "in long double",
           return (double)(2.0L * distance * tanl(degrees * 3.14159265358979323846264L / 360)))
