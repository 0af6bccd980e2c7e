// 02-cameras.c - calls that tell mistakes of exercise 02 apart: any cameras in each form, of both
// hands, and some that are none.
#include "tests/02-cameras.h"

#include "tests/judge/suspects.h"

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

// What *camera holds before is another camera each time.
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
        ask(form, c, corners_of(c));
    }
}

// Off the axis, or sheared, along each direction.
static void ask_of_none(Form form)
{
    for (int i = 0; i < MANY; i++) {
        Camera c = random_camera();
        Corners v = corners_of(c);
        vec3 off = random_number(0.05, 2) * (i % 2 == 0 ? c.right : c.up);
        if (i % 4 < 2)
            v.lower_left += off, v.lower_right += off;
        v.upper_left += off, v.upper_right += off;
        ask(form, c, v);
    }
}

START_TEST(vectors_to_any_rectangle)
{
    ask_of_cameras(VECTORS);
}
END_TEST

START_TEST(vectors_to_what_is_none)
{
    ask_of_none(VECTORS);
}
END_TEST

START_TEST(points_of_any_rectangle)
{
    ask_of_cameras(POINTS);
}
END_TEST

START_TEST(points_of_what_is_none)
{
    ask_of_none(POINTS);
}
END_TEST

START_TEST(corner_of_any_rectangle)
{
    ask_of_cameras(CORNER);
}
END_TEST

START_TEST(corner_of_what_is_none)
{
    ask_of_none(CORNER);
}
END_TEST

START_TEST(any_view)
{
    for (int i = 0; i < 2 * MANY; i++) {
        vec3 eye = random_vec3(-5, 5);
        vec3 at = eye + random_number(0.3, 6) * random_unit();
        vec3 up = random_number(0.3, 3) * random_unit();
        double width = random_number(0.5, 4);
        LookAt view = {
            .eye = eye, .at = at, .up = up, .width = width, .aspect = random_number(0.4, 2.5)};
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

void list_probes(void)
{
    tests_of("camera_from_vectors");
    test(vectors_to_any_rectangle);
    test(vectors_to_what_is_none);
    tests_of("camera_from_points");
    test(points_of_any_rectangle);
    test(points_of_what_is_none);
    tests_of("camera_from_corner");
    test(corner_of_any_rectangle);
    test(corner_of_what_is_none);
    tests_of("camera_from_look_at");
    test(any_view);
    tests_of("width_from_angle");
    test(any_angle);
}
