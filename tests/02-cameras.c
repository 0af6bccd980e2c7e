// 02-cameras.c - tests of exercise 02. Expected: the deck's camera, cameras worked by hand, and
// that a camera taken apart along its own axes is found again.
//
// Here: what they share, and the width from an angle.
#include "tests/02-cameras.h"

Camera oblique_camera(void)
{
    return (Camera){.origin = vec3_of(3, -5, 7),
                    .right = vec3_of(2, -2, 1) / 3,
                    .up = vec3_of(2, 1, -2) / 3,
                    .forward = vec3_of(1, 2, 2) / 3,
                    .distance = 6,
                    .width = 9,
                    .height = 3};
}

Camera mirrored(Camera c)
{
    c.right = -c.right;
    return c;
}

Camera untouched(void)
{
    return (Camera){.origin = vec3_of(11, 12, 13),
                    .right = vec3_of(14, 15, 16),
                    .up = vec3_of(17, 18, 19),
                    .forward = vec3_of(20, 21, 22),
                    .distance = 23,
                    .width = 24,
                    .height = 25};
}

void expect_found(CameraFault fault, Camera found, Camera expected)
{
    expect_found_of_size(fault, found, expected, 1);
}

void expect_found_of_size(CameraFault fault, Camera found, Camera expected, double size)
{
    if (fault != CAMERA_OK)
        expect_fault(fault, CAMERA_OK);
    expect_camera_of_size(found, expected, TOLERANCE, size);
}

Camera camera_number(int i)
{
    return i < 5 ? camera_of_the_deck() : random_camera();
}

Camera camera_of_any_size(int i, int count, double *size)
{
    Camera c = random_camera();
    *size = pow(random_scale(i, count), 1.5);
    c.origin *= *size;
    c.distance *= *size;
    c.width *= *size;
    c.height *= *size;
    return c;
}

Normalized random_place(void)
{
    double s = floor(random_number(0, 21)) / 20;
    return (Normalized){s, floor(random_number(0, 21)) / 20};
}

void expect_same_ray_through(Normalized place, CameraFault fault, Camera yours, Camera same)
{
    if (fault != CAMERA_OK)
        expect_fault(fault, CAMERA_OK);
    given("seen", "the ray through (s, t) = %s", pair_text(place.s, place.t).s);
    Ray ray = {yours.origin, image_plane_vector(yours, place.s, place.t)};
    Ray expected = {same.origin, vec3_unit(image_plane_vector(same, place.s, place.t))};
    expect_same_ray(ray, expected, 1e-12);
}

CameraFault first_of(int reasons)
{
    int fault = CAMERA_OK;
    while ((reasons >> fault & 1) == 0)
        fault++;
    return (CameraFault)fault;
}

void expect_refused(CameraFault fault, Camera after, int reasons, int also)
{
    bool is_reason =
        fault > CAMERA_OK && fault < CAMERA_FAULTS && ((reasons | also) >> fault & 1) == 1;
    if (!is_reason)
        expect_fault(fault, first_of(reasons));
    given("refused", "and *camera stays as it was");
    expect_camera(after, untouched(), 0);
}

double not_finite(int i)
{
    static const double values[] = {NAN, INFINITY, -INFINITY};
    return values[i % 3];
}

// ---- width from angle -------------------------------------------------------------------------

static void expect_width_of_size(double degrees, double distance, double width, double size)
{
    given_number("degrees", degrees);
    given_number("distance", distance);
    expect_number(width_from_angle(degrees, distance), width, TOLERANCE * size);
}

static void expect_width(double degrees, double distance, double width)
{
    expect_width_of_size(degrees, distance, width, 1);
}

// Half of the picture is a right-angled triangle with two equal legs.
START_TEST(under_90_degrees_the_plane_is_twice_as_wide_as_far)
{
    expect_width(90, 1, 2);
    expect_width(90, 3.5, 7);
}
END_TEST

// By hand: eye and edges are an equilateral triangle, its height the distance.
START_TEST(under_60_degrees_the_plane_is_as_wide_as_the_edges_are_far)
{
    expect_width(60, 1, 2 / sqrt(3));
    expect_width(60, sqrt(3), 2);
}
END_TEST

// By hand: the tangent of 22.5 degrees is sqrt(2) - 1, of 15 it is 2 - sqrt(3), of 60 sqrt(3).
START_TEST(under_30_and_45_and_120_degrees_the_tangents_are_known)
{
    expect_width(45, 1, 2 * sqrt(2) - 2);
    expect_width(30, 1, 4 - 2 * sqrt(3));
    expect_width(120, 1, 2 * sqrt(3));
}
END_TEST

START_TEST(twice_as_far_away_is_twice_as_wide)
{
    double degrees[] = {20, 50, 100};
    for (int i = 0; i < 3; i++) {
        given_number("degrees", degrees[i]);
        given("distance", "6 and 3");
        given("seen", "the width at 6, by the width at 3");
        expect_number(width_from_angle(degrees[i], 6) / width_from_angle(degrees[i], 3), 2,
                      TOLERANCE);
    }
}
END_TEST

// There an arc and its tangent are the same to 20 digits.
START_TEST(under_a_very_small_angle_the_width_is_that_of_the_arc)
{
    given_number("degrees", 1e-6);
    given_number("distance", 180e6);
    expect_number(width_from_angle(1e-6, 180e6), PI, TOLERANCE);
}
END_TEST

// The law of scale: the width grows with the distance.
START_TEST(at_any_distance_the_width_grows_with_it)
{
    enum { COUNT = 13 };
    for (int i = 0; i < COUNT; i++) {
        double distance = random_scale(i, COUNT) * random_number(1, 9);
        expect_width_of_size(90, distance, 2 * distance, distance);
    }
}
END_TEST

// For a small x the tangent is x + x^3 / 3 + 2 x^5 / 15 + 17 x^7 / 315.
START_TEST(under_any_small_angle_the_width_is_that_of_the_tangents_series)
{
    for (int i = 0; i < 10; i++) {
        double degrees = pow(10, -6 + 0.6 * i) * random_number(1, 2), distance = 2;
        double x = degrees * PI / 360;
        double series = x + pow(x, 3) / 3 + 2 * pow(x, 5) / 15 + 17 * pow(x, 7) / 315;
        expect_width_of_size(degrees, distance, 2 * distance * series, 2 * distance * series);
    }
}
END_TEST

// Whole numbers first: they are shorter to read.
START_TEST(from_the_eye_the_edges_are_that_angle_apart)
{
    for (int i = 0; i < 25; i++) {
        double degrees = random_number(1, 175), distance = random_number(1, 20);
        if (i < 15) {
            degrees = floor(degrees);
            distance = floor(distance);
        }
        given_number("degrees", degrees);
        given_number("distance", distance);
        given("seen", "the angle between the edges, in degrees");
        double half = atan2(width_from_angle(degrees, distance) / 2, distance);
        expect_number(2 * half * 180 / PI, degrees, TOLERANCE);
    }
}
END_TEST

void list_tests(void)
{
    list_tests_of_vectors();
    list_tests_of_points();
    list_tests_of_corner();
    list_tests_of_look_at();
    tests_of("width_from_angle");
    test(under_90_degrees_the_plane_is_twice_as_wide_as_far);
    test(under_60_degrees_the_plane_is_as_wide_as_the_edges_are_far);
    test(under_30_and_45_and_120_degrees_the_tangents_are_known);
    test(twice_as_far_away_is_twice_as_wide);
    test(under_a_very_small_angle_the_width_is_that_of_the_arc);
    test(at_any_distance_the_width_grows_with_it);
    test(under_any_small_angle_the_width_is_that_of_the_tangents_series);
    test(from_the_eye_the_edges_are_that_angle_apart);
}
