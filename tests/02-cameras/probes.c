// probes.c - calls that distinguish the mistakes of exercise 02: any cameras in each form, of both
// handednesses, and some that must be refused.
#include "tests/02-cameras/support.h"

#include "tests/judge/suspects.h"

#include <math.h>

enum { MANY = 16 };

static vec3 corner(Camera c, double x, double y)
{
    return c.distance * c.forward + x * c.width / 2 * c.right + y * c.height / 2 * c.up;
}

static Corners corners_of(Camera c)
{
    return (Corners){.upper_left = corner(c, -1, 1),
                     .upper_right = corner(c, 1, 1),
                     .lower_left = corner(c, -1, -1),
                     .lower_right = corner(c, 1, -1)};
}

// *camera holds another camera before each call.
static void ask(Form form, Camera c, Corners from_the_eye)
{
    Corners v = from_the_eye, points = {v.upper_left + c.origin, v.upper_right + c.origin,
                                        v.lower_left + c.origin, v.lower_right + c.origin};
    Camera before = random_camera();
    if (form == VECTORS)
        camera_from_vectors(c.origin, v, &before);
    else if (form == POINTS)
        camera_from_points(c.origin, points, &before);
    else
        camera_from_corner(c.origin, points.lower_left, v.lower_right - v.lower_left,
                           v.upper_left - v.lower_left, &before);
}

static void ask_of_cameras(Form form)
{
    for (int i = 0; i < MANY; i++) {
        Camera c = random_camera();
        if (i % 4 == 3) // the mean is a unit vector
            c.distance = 1;
        if (i % 8 == 1)
            c.height = c.width;
        if (i % 8 == 6) // vectors and points are the same
            c.origin = vec3_of(0, 0, 0);
        ask(form, c, corners_of(c));
    }
}

// One thing wrong with the corners at a time: off the axis, sheared, one corner elsewhere, flat, or
// not finite.
static Corners spoilt_corners(Camera c, int i)
{
    double off = random_number(0.05, 2);
    if (i % 8 == 4)
        c.distance = 0;
    if (i % 8 == 5)
        *(i / 8 % 2 == 0 ? &c.width : &c.height) = 0;
    Corners v = corners_of(c);
    vec3 *corners[] = {&v.upper_left, &v.upper_right, &v.lower_left, &v.lower_right};
    vec3 side = i / 8 % 2 == 0 ? c.right : c.up;
    switch (i % 8) {
    case 0:
        for (int k = 0; k < 4; k++)
            *corners[k] += off * side;
        break;
    case 1:
        v.upper_left += off * side;
        v.upper_right += off * side;
        break;
    case 2:
        v.lower_left += off * side;
        v.lower_right += off * side;
        break;
    case 3:
        *corners[i / 8 % 4] += off * random_unit();
        break;
    case 6:
        (*corners[i / 8 % 4])[i / 8 % 3] = not_finite(i / 8 % 3);
        break;
    case 7:
        *corners[3] += off * (i / 8 % 2 == 0 ? random_unit() : c.forward);
        break;
    default:;
    }
    return v;
}

static void ask_of_none(Form form)
{
    for (int i = 0; i < 4 * MANY; i++) {
        Camera c = random_camera();
        Corners v = i % 16 == 14 ? corners_of(c) : spoilt_corners(c, i);
        if (i % 16 == 14)
            c.origin[i / 16 % 3] = not_finite(i / 16 % 3);
        if (i % 16 == 11)
            c.origin = vec3_of(0, 0, 0);
        ask(form, c, v);
    }
}

static double any_scale(void)
{
    return pow(10, random_number(-9, 6));
}

// Straight ahead, but not a rectangle: sheared, leaning, one corner elsewhere, or bent; and
// rectangles that are only shifted to the side or up, or turned. In worlds of any size.
static Corners spoilt_alone(Camera c, int i)
{
    Corners v = corners_of(c);
    vec3 *corners[] = {&v.upper_left, &v.upper_right, &v.lower_left, &v.lower_right};
    double off = (i % 2 == 0 ? 1 : -1) * pow(10, random_number(-4, 0)) * c.distance;
    vec3 moved[4] = {vec3_of(0, 0, 0)}, way = random_unit();
    int astray = i / 7 % 2 == 0 ? 3 : i / 14 % 3; // mostly the one that edges do not begin at
    for (int k = 0; k < 4; k++) {
        double x = k % 2 == 0 ? -1 : 1, y = k < 2 ? 1 : -1;
        moved[k] = i % 7 == 0   ? y * off * c.right
                   : i % 7 == 1 ? x * off * c.up
                   : i % 7 == 2 ? (k == astray ? 1 : -1 / 3.) * off * way
                   : i % 7 == 3 ? x * y * off * c.forward
                   : i % 7 == 4 ? off * c.right
                   : i % 7 == 5 ? off * c.up
                                : (i / 7 % 2 == 0 ? x : y) * off * c.forward;
    }
    for (int k = 0; k < 4; k++)
        *corners[k] += moved[k];
    return v;
}

static void ask_of_single_faults(Form form)
{
    for (int i = 0; i < 4 * MANY; i++) {
        Camera c = random_camera();
        double scale = any_scale();
        double width = c.width;
        if (i / 2 % 2 == 1) { // wide and high
            c.width = c.height;
            c.height = width;
        }
        c.origin *= scale;
        c.distance *= scale;
        c.width *= scale;
        c.height *= scale;
        ask(form, c, spoilt_alone(c, i));
    }
}

// Planes that are narrow or low beside their distance, by any amount.
static void ask_of_slender_planes(Form form)
{
    for (int i = 0; i < MANY; i++) {
        Camera c = random_camera();
        *(i % 2 == 0 ? &c.width : &c.height) *= pow(10, random_number(-4, -1));
        ask(form, c, corners_of(c));
        double small = pow(10, random_number(-6.3, -5.7)); // a fixed limit between its sides
        c = random_camera();
        c.origin = vec3_of(0, 0, 0);
        c.distance = 4 * small;
        c.width = (i % 2 == 0 ? 4 : 0.3) * small;
        c.height = (i % 2 == 0 ? 0.3 : 4) * small;
        ask(form, c, corners_of(c));
    }
}

// An eye on its own axis: then points could also be read as vectors.
static void ask_from_the_axis(Form form)
{
    for (int i = 0; i < MANY; i++) {
        Camera c = random_camera();
        c.origin = random_number(0.3, 4) * c.forward;
        ask(form, c, corners_of(c));
    }
}

START_TEST(vectors_to_any_rectangle)
{
    ask_of_cameras(VECTORS);
    ask_from_the_axis(VECTORS);
    ask_of_slender_planes(VECTORS);
}
END_TEST

START_TEST(vectors_to_what_is_none)
{
    ask_of_none(VECTORS);
    ask_of_single_faults(VECTORS);
}
END_TEST

START_TEST(points_of_any_rectangle)
{
    ask_of_cameras(POINTS);
    ask_from_the_axis(POINTS);
    ask_of_slender_planes(POINTS);
}
END_TEST

// Then the points are a camera's whatever multiple of the eye is added.
START_TEST(points_straight_ahead_of_the_origin)
{
    for (int i = 0; i < MANY; i++) {
        Camera c = random_camera();
        c.origin = random_number(0.1, 5) * c.forward;
        ask(POINTS, c, corners_of(c));
    }
}
END_TEST

START_TEST(points_of_what_is_none)
{
    ask_of_none(POINTS);
    ask_of_single_faults(POINTS);
}
END_TEST

START_TEST(corner_of_any_rectangle)
{
    ask_of_cameras(CORNER);
    ask_from_the_axis(CORNER);
    ask_of_slender_planes(CORNER);
}
END_TEST

// Edges that are unit vectors, at any distance.
START_TEST(corner_of_a_unit_square)
{
    for (int i = 0; i < MANY; i++) {
        Camera c = random_camera();
        c.width = c.height = 1;
        ask(CORNER, c, corners_of(c));
    }
}
END_TEST

START_TEST(corner_of_what_is_none)
{
    ask_of_none(CORNER);
    ask_of_single_faults(CORNER);
    for (int i = 0; i < MANY; i++) { // up along across, straight ahead
        Camera before = random_camera();
        vec3 across = random_vec3(-2, 2), corner = random_vec3(-5, 5);
        vec3 up = random_number(-2, 2) * across;
        vec3 ahead = random_number(1, 5) * vec3_unit(vec3_cross(across, random_unit()));
        camera_from_corner(corner + across / 2 + up / 2 - ahead, corner, across, up, &before);
    }
}
END_TEST

// One thing wrong with a view at a time.
static LookAt spoilt(LookAt view, int i)
{
    vec3 forward = view.at - view.eye;
    int way = i / 12;
    if (way % 2 == 1) { // close by
        forward *= random_number(0.05, 0.9) / vec3_length(forward);
        view.at = view.eye + forward;
    }
    switch (i % 12) {
    case 0:
        view.at = view.eye;
        break;
    case 1:
        view.up = random_number(0.2, 4) * forward;
        break;
    case 2:
        view.up = -random_number(0.2, 4) * forward;
        break;
    case 3:
        view.up = vec3_of(0, 0, 0);
        break;
    case 4:
        view.width = way % 2 == 0 ? 0 : -random_number(0.1, 3);
        break;
    case 5:
        view.aspect = way % 2 == 0 ? 0 : -random_number(0.1, 3);
        break;
    case 6:
        view.width = not_finite(way % 3);
        break;
    case 7:
        view.aspect = not_finite(way % 3);
        break;
    case 8:
        view.eye[way % 3] = not_finite(way % 3);
        break;
    case 9:
        view.at[way % 3] = not_finite(way % 3);
        break;
    case 10:
        view.up[way % 3] = not_finite(way % 3);
        break;
    default: // none: up leans, and is short
        view.up = random_number(1e-6, 1e-3) * (forward + random_number(0.05, 0.3) * random_unit());
    }
    return view;
}

static LookAt any_look_at(void)
{
    vec3 eye = random_vec3(-5, 5);
    vec3 at = eye + random_number(0.3, 6) * random_unit();
    vec3 up = random_number(0.3, 3) * random_unit();
    double width = random_number(0.5, 4);
    return (LookAt){
        .eye = eye, .at = at, .up = up, .width = width, .aspect = random_number(0.4, 2.5)};
}

START_TEST(any_view)
{
    for (int i = 0; i < 2 * MANY; i++) {
        LookAt view = any_look_at();
        Camera before = random_camera();
        camera_from_look_at(view, i % 2 == 0 ? RIGHT_HANDED : LEFT_HANDED, &before);
    }
}
END_TEST

// Near, narrow, or with a short up; alone.
START_TEST(any_small_view)
{
    for (int i = 0; i < 2 * MANY; i++) {
        LookAt view = any_look_at();
        double small = pow(10, random_number(-13, -5));
        if (i % 3 == 0) {
            view.at = small * (view.at - view.eye);
            view.eye = vec3_of(0, 0, 0);
        }
        if (i % 3 == 1)
            view.width *= small;
        if (i % 3 == 2)
            view.up *= small;
        Camera before = random_camera();
        camera_from_look_at(view, i % 2 == 0 ? RIGHT_HANDED : LEFT_HANDED, &before);
    }
}
END_TEST

START_TEST(views_that_are_none)
{
    for (int i = 0; i < 48; i++) {
        LookAt view = spoilt(any_look_at(), i);
        Camera before = random_camera();
        camera_from_look_at(view, i % 2 == 0 ? RIGHT_HANDED : LEFT_HANDED, &before);
    }
}
END_TEST

START_TEST(any_angle)
{
    for (int i = 0; i < MANY; i++) {
        double degrees = random_number(5, 175);
        width_from_angle(degrees, random_number(0.2, 7));
    }
}
END_TEST

static void list_probes(void)
{
    tests_of("camera_from_vectors");
    test(vectors_to_any_rectangle);
    test(vectors_to_what_is_none);
    tests_of("camera_from_points");
    test(points_of_any_rectangle);
    test(points_straight_ahead_of_the_origin);
    test(points_of_what_is_none);
    tests_of("camera_from_corner");
    test(corner_of_any_rectangle);
    test(corner_of_a_unit_square);
    test(corner_of_what_is_none);
    tests_of("camera_from_look_at");
    test(any_view);
    test(any_small_view);
    test(views_that_are_none);
    tests_of("width_from_angle");
    test(any_angle);
}

OF_STEM(list_probes)
