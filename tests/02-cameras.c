// 02-cameras.c - tests of exercise 02. Expected values: the deck's camera, cameras worked out by
// hand, and cameras that are taken apart along their own axes and must be found again.
#include "tests/02-cameras/support.h"

// ---- eye and four vectors ----------------------------------------------------------------------

START_TEST(the_four_vectors_of_the_deck_give_its_camera)
{
    vec3 in[] = {{2, 2, -4}, {-1, 1, 4}, {1, 1, 4}, {-1, -1, 4}, {1, -1, 4}};
    finds(VECTORS, in, camera_of_the_deck());
}
END_TEST

// By hand: (2, 4, 4), then 4.5 r = (3, -3, 1.5) and 1.5 u = (1, 0.5, -1), to and fro.
START_TEST(four_vectors_give_an_oblique_camera_of_either_hand)
{
    vec3 in[] = {{3, -5, 7}, {0, 7.5, 1.5}, {6, 1.5, 4.5}, {-2, 6.5, 3.5}, {4, 0.5, 6.5}};
    vec3 swapped[] = {in[0], in[2], in[1], in[4], in[3]};
    finds(VECTORS, swapped, mirrored(oblique_camera()));
    finds(VECTORS, in, oblique_camera());
}
END_TEST

START_TEST(four_vectors_of_any_camera_give_it_back)
{
    finds_random_cameras(VECTORS);
}
END_TEST

START_TEST(four_vectors_keep_the_rays_to_twelve_digits)
{
    keeps_the_rays(VECTORS);
}
END_TEST

START_TEST(four_vectors_that_do_not_end_in_a_rectangle_are_refused)
{
    refuses(VECTORS, RECTANGLE);
}
END_TEST

START_TEST(four_vectors_to_a_rectangle_not_straight_ahead_are_refused)
{
    refuses(VECTORS, AXIS);
}
END_TEST

START_TEST(four_vectors_that_leave_no_distance_width_or_height_are_refused)
{
    refuses(VECTORS, DISTANCE | WIDTH | HEIGHT);
}
END_TEST

START_TEST(four_vectors_pushed_out_of_shape_or_place_are_refused)
{
    refuses_what_was_pushed(VECTORS);
}
END_TEST

START_TEST(four_vectors_that_are_not_finite_are_refused)
{
    refuses_what_is_not_finite(VECTORS);
}
END_TEST

START_TEST(four_vectors_in_worlds_of_any_size_give_the_camera)
{
    finds_cameras_of_any_size(VECTORS);
}
END_TEST

START_TEST(four_vectors_of_an_invalid_camera_are_refused_in_worlds_of_any_size)
{
    refuses_in_worlds_of_any_size(VECTORS);
}
END_TEST

// ---- eye and four points -----------------------------------------------------------------------

// The deck draws the plane at z = 0, with x and y from 1 to 3.
START_TEST(the_four_points_of_the_deck_give_its_camera)
{
    vec3 in[] = {{2, 2, -4}, {1, 3, 0}, {3, 3, 0}, {1, 1, 0}, {3, 1, 0}};
    finds(POINTS, in, camera_of_the_deck());
}
END_TEST

// By hand: the four vectors above, added to the eye.
START_TEST(four_points_give_an_oblique_camera_of_either_hand)
{
    vec3 in[] = {{3, -5, 7}, {3, 2.5, 8.5}, {9, -3.5, 11.5}, {1, 1.5, 10.5}, {7, -4.5, 13.5}};
    vec3 swapped[] = {in[0], in[2], in[1], in[4], in[3]};
    finds(POINTS, swapped, mirrored(oblique_camera()));
    finds(POINTS, in, oblique_camera());
}
END_TEST

START_TEST(four_points_of_any_camera_give_it_back)
{
    finds_random_cameras(POINTS);
}
END_TEST

START_TEST(four_points_keep_the_rays_to_twelve_digits)
{
    keeps_the_rays(POINTS);
}
END_TEST

START_TEST(four_points_that_are_not_a_rectangle_are_refused)
{
    refuses(POINTS, RECTANGLE);
}
END_TEST

START_TEST(four_points_of_a_rectangle_not_straight_ahead_are_refused)
{
    refuses(POINTS, AXIS);
}
END_TEST

START_TEST(four_points_that_leave_no_distance_width_or_height_are_refused)
{
    refuses(POINTS, DISTANCE | WIDTH | HEIGHT);
}
END_TEST

START_TEST(four_points_pushed_out_of_shape_or_place_are_refused)
{
    refuses_what_was_pushed(POINTS);
}
END_TEST

START_TEST(four_points_that_are_not_finite_are_refused)
{
    refuses_what_is_not_finite(POINTS);
}
END_TEST

START_TEST(four_points_in_worlds_of_any_size_give_the_camera)
{
    finds_cameras_of_any_size(POINTS);
}
END_TEST

START_TEST(four_points_of_an_invalid_camera_are_refused_in_worlds_of_any_size)
{
    refuses_in_worlds_of_any_size(POINTS);
}
END_TEST

// ---- eye, lower left corner and two vectors ----------------------------------------------------

START_TEST(the_corner_and_two_vectors_of_the_deck_give_its_camera)
{
    vec3 in[] = {{2, 2, -4}, {1, 1, 0}, {2, 0, 0}, {0, 2, 0}};
    finds(CORNER, in, camera_of_the_deck());
}
END_TEST

// By hand: the lower left point above, 9 r = (6, -6, 3), 3 u = (2, 1, -2); mirrored, the corner is
// the lower right point.
START_TEST(a_corner_and_two_vectors_give_an_oblique_camera_of_either_hand)
{
    vec3 in[] = {{3, -5, 7}, {1, 1.5, 10.5}, {6, -6, 3}, {2, 1, -2}};
    vec3 swapped[] = {{3, -5, 7}, {7, -4.5, 13.5}, {-6, 6, -3}, {2, 1, -2}};
    finds(CORNER, swapped, mirrored(oblique_camera()));
    finds(CORNER, in, oblique_camera());
}
END_TEST

START_TEST(the_corner_and_two_vectors_of_any_camera_give_it_back)
{
    finds_random_cameras(CORNER);
}
END_TEST

START_TEST(a_corner_and_two_vectors_keep_the_rays_to_twelve_digits)
{
    keeps_the_rays(CORNER);
}
END_TEST

START_TEST(two_vectors_that_are_not_at_right_angles_are_refused)
{
    refuses(CORNER, RECTANGLE);
}
END_TEST

START_TEST(a_corner_and_two_vectors_of_a_rectangle_not_straight_ahead_are_refused)
{
    refuses(CORNER, AXIS);
}
END_TEST

START_TEST(a_corner_and_two_vectors_that_leave_no_distance_width_or_height_are_refused)
{
    refuses(CORNER, DISTANCE | WIDTH | HEIGHT);
}
END_TEST

START_TEST(a_corner_and_two_vectors_pushed_out_of_shape_or_place_are_refused)
{
    refuses_what_was_pushed(CORNER);
}
END_TEST

START_TEST(a_corner_and_two_vectors_that_are_not_finite_are_refused)
{
    refuses_what_is_not_finite(CORNER);
}
END_TEST

START_TEST(a_corner_and_two_vectors_in_worlds_of_any_size_give_the_camera)
{
    finds_cameras_of_any_size(CORNER);
}
END_TEST

START_TEST(corner_and_vectors_of_an_invalid_camera_are_refused_in_worlds_of_any_size)
{
    refuses_in_worlds_of_any_size(CORNER);
}
END_TEST

// ---- look-at: the cameras that it must find ----------------------------------------------------

// Says what is given, and calls the function.
static CameraFault look(LookAt view, Handedness world, Camera *camera)
{
    *camera = untouched();
    given_vec3("eye", view.eye);
    given_vec3("at", view.at);
    given_vec3("up", view.up);
    given_number("width", view.width);
    given_number("aspect", view.aspect);
    given("world", world == RIGHT_HANDED ? "right-handed" : "left-handed");
    return camera_from_look_at(view, world, camera);
}

static void look_finds(LookAt view, Handedness world, Camera expected)
{
    Camera found;
    CameraFault fault = look(view, world, &found);
    expect_found(fault, found, expected);
}

// The deck's, except for these.
static LookAt deck_with(vec3 up, double width, double aspect)
{
    return (LookAt){vec3_of(2, 2, -4), vec3_of(2, 2, 0), up, width, aspect};
}

static LookAt look_at_of_the_deck(void)
{
    return deck_with(vec3_of(0, 1, 0), 2, 1);
}

static LookAt deck_with_size(double width, double aspect)
{
    return deck_with(vec3_of(0, 1, 0), width, aspect);
}

// By hand: the eye and 6 f = (2, 4, 4) are the point looked at; up is 3 u.
static LookAt oblique_look_at(void)
{
    return (LookAt){vec3_of(3, -5, 7), vec3_of(5, -1, 11), vec3_of(2, 1, -2), 9, 3};
}

// A look-at that must give the camera; its up leans towards the view or away from it.
static LookAt random_look_at(Camera c)
{
    double lean = random_number(-2, 2), size = random_number(0.1, 9);
    return (LookAt){c.origin, c.origin + c.distance * c.forward, size * (c.up + lean * c.forward),
                    c.width, c.width / c.height};
}

// The hand whose thumb, first and middle finger are right, up and forward.
static Handedness hand_of(Camera c)
{
    return vec3_dot(vec3_cross(c.right, c.up), c.forward) > 0 ? LEFT_HANDED : RIGHT_HANDED;
}

START_TEST(the_look_at_of_the_deck_gives_its_camera_in_a_left_handed_world)
{
    look_finds(look_at_of_the_deck(), LEFT_HANDED, camera_of_the_deck());
}
END_TEST

START_TEST(the_look_at_of_the_deck_is_mirrored_in_a_right_handed_world)
{
    look_finds(look_at_of_the_deck(), RIGHT_HANDED, mirrored(camera_of_the_deck()));
}
END_TEST

// As in scenes: x to the right, y up, and z towards the eye.
START_TEST(along_minus_z_in_a_right_handed_world_x_is_to_the_right)
{
    LookAt view = {vec3_of(1, 2, 9), vec3_of(1, 2, 4), vec3_of(0, 1, 0), 4, 2};
    Camera c = {vec3_of(1, 2, 9), vec3_of(1, 0, 0), vec3_of(0, 1, 0), vec3_of(0, 0, -1), 5, 4, 2};
    look_finds(view, RIGHT_HANDED, c);
}
END_TEST

START_TEST(an_oblique_look_at_in_a_world_of_either_hand)
{
    look_finds(oblique_look_at(), LEFT_HANDED, oblique_camera());
    look_finds(oblique_look_at(), RIGHT_HANDED, mirrored(oblique_camera()));
}
END_TEST

// By hand: u + f = (1, 1, 0), whose part across the view is 1 long; (4 u + 3 f) / 5, which is 1
// long itself; 3 u + 3 f = (3, 3, 0), 3 u - 3 f = (1, -1, -4), 30 u = (20, 10, -20). The last is
// very short, but not 0.
START_TEST(up_may_lean_and_have_any_length)
{
    static const vec3 ups[] = {
        {1, 1, 0},     {11.0 / 15, 2.0 / 3, -2.0 / 15}, {3, 3, 0}, {1, -1, -4},
        {20, 10, -20}, {2e-12, 1e-12, -2e-12},
    };
    for (size_t i = 0; i < sizeof ups / sizeof ups[0]; i++) {
        LookAt view = oblique_look_at();
        view.up = ups[i];
        look_finds(view, LEFT_HANDED, oblique_camera());
        look_finds(view, RIGHT_HANDED, mirrored(oblique_camera()));
    }
}
END_TEST

START_TEST(up_may_lean_until_it_is_almost_along_the_view)
{
    look_finds(deck_with(vec3_of(0, 0.001, 1), 2, 1), LEFT_HANDED, camera_of_the_deck());
    look_finds(deck_with(vec3_of(0, 1e-7, 1), 2, 1), LEFT_HANDED, camera_of_the_deck());
}
END_TEST

// By hand: 4 wide on a screen of 640 x 480 is 3 high.
START_TEST(the_height_is_the_width_divided_by_the_aspect)
{
    Camera c = camera_of_the_deck();
    c.width = 4;
    c.height = 3;
    look_finds(deck_with_size(4, 640.0 / 480), LEFT_HANDED, c);
}
END_TEST

static vec3 whole_numbers(void)
{
    vec3 v = random_vec3(-9, 10);
    return vec3_of(floor(v[0]), floor(v[1]), floor(v[2]));
}

START_TEST(the_plane_passes_through_the_point_looked_at)
{
    for (int i = 0; i < 15; i++) {
        vec3 eye = whole_numbers(), at = whole_numbers(), up = whole_numbers();
        LookAt view = {eye, at, up, 2, 1};
        if (vec3_length(vec3_cross(at - eye, up)) == 0)
            continue; // by chance there is not a camera
        Camera found;
        CameraFault fault = look(view, i % 2 == 0 ? RIGHT_HANDED : LEFT_HANDED, &found);
        if (fault != CAMERA_OK)
            expect_fault(fault, CAMERA_OK);
        given("seen", "the middle of the plane");
        expect_vec3(found.origin + found.distance * found.forward, view.at, TOLERANCE);
    }
}
END_TEST

START_TEST(the_look_at_of_any_camera_gives_it_back)
{
    for (int i = 0; i < 15; i++) {
        Camera c = random_camera();
        look_finds(random_look_at(c), hand_of(c), c);
    }
}
END_TEST

// The law of scale: with eye, at and width k times as large, the camera is k times as large; the
// length of up is free.
START_TEST(a_look_at_in_worlds_of_any_size_gives_the_camera)
{
    enum { COUNT = 13 };
    for (int i = 0; i < COUNT; i++) {
        double size;
        Camera c = camera_of_any_size(i, COUNT, &size), found;
        LookAt view = random_look_at(c);
        view.up *= random_scale((5 * i) % COUNT, COUNT);
        CameraFault fault = look(view, hand_of(c), &found);
        expect_found_of_size(fault, found, c, size);
    }
}
END_TEST

START_TEST(a_look_at_keeps_the_rays_to_twelve_digits)
{
    for (int i = 0; i < 15; i++) {
        Camera c = camera_number(i), found;
        Normalized place = random_place();
        CameraFault fault = look(random_look_at(c), hand_of(c), &found);
        expect_same_ray_through(place, fault, found, c);
    }
}
END_TEST

// The cross product is then a hundred millionth long, and rounding shows: right must be made
// perpendicular once more, or the camera is refused. Extra: the deck's formula need not do that.
START_TEST(up_may_be_almost_along_an_oblique_view)
{
    for (int i = 0; i < 15; i++) {
        Camera c = random_camera(), found;
        LookAt view = {c.origin, c.origin + c.distance * c.forward, c.forward + 1e-8 * c.up,
                       c.width, c.width / c.height};
        expect_fault(look(view, hand_of(c), &found), CAMERA_OK);
    }
}
END_TEST

// ---- look-at: what must be refused -------------------------------------------------------------

// In either world.
static void look_refuses_also(LookAt view, int reasons, int also)
{
    Camera after;
    CameraFault fault = look(view, RIGHT_HANDED, &after);
    expect_refused(fault, after, reasons, also);
    fault = look(view, LEFT_HANDED, &after);
    expect_refused(fault, after, reasons, also);
}

static void look_refuses(LookAt view, int reasons)
{
    look_refuses_also(view, reasons, 0);
}

// The plane passes through the point looked at, so the distance is 0 as well.
START_TEST(looking_at_the_eye_itself_is_refused)
{
    LookAt view = look_at_of_the_deck();
    view.at = view.eye;
    look_refuses_also(view, DIRECTION, DISTANCE);
}
END_TEST

START_TEST(an_up_of_zero_is_refused)
{
    look_refuses(deck_with(vec3_of(0, 0, 0), 2, 1), UP);
}
END_TEST

// Once in round numbers, then with numbers whose rounding leaves a little to the side.
static void look_refuses_an_up_along_the_view(double sign)
{
    LookAt view = deck_with(vec3_of(0, 0, 5 * sign), 2, 1);
    look_refuses(view, UP);
    for (int i = 0; i < 10; i++) {
        vec3 forward = random_unit();
        view.eye = random_vec3(-5, 5);
        view.at = view.eye + (i % 3 == 0 ? 0.3 : 3) * forward;
        view.up = sign * random_number(0.1, i % 2 == 0 ? 0.9 : 9) * forward;
        look_refuses(view, UP);
    }
}

START_TEST(an_up_along_the_view_is_refused)
{
    look_refuses_an_up_along_the_view(1);
}
END_TEST

START_TEST(an_up_against_the_view_is_refused)
{
    look_refuses_an_up_along_the_view(-1);
}
END_TEST

START_TEST(a_width_that_is_not_positive_is_refused)
{
    look_refuses(deck_with_size(0, 1), WIDTH | HEIGHT);
    look_refuses(deck_with_size(-2, 1), WIDTH | HEIGHT);
    for (int i = 0; i < 5; i++)
        look_refuses(deck_with_size(-random_number(0.1, 9), 1.5), WIDTH | HEIGHT);
}
END_TEST

// With an aspect of 0 the height is infinite.
START_TEST(an_aspect_that_is_not_positive_is_refused)
{
    look_refuses_also(deck_with_size(2, 0), HEIGHT, FINITE);
    look_refuses(deck_with_size(2, -1), HEIGHT);
    for (int i = 0; i < 6; i++)
        look_refuses(deck_with_size(i % 2 == 0 ? 3 : 0.3, -random_number(0.1, 9)), HEIGHT);
}
END_TEST

// From infinitely far above, the view is along up, and so is an up that is infinite along the view.
START_TEST(a_look_at_whose_vectors_are_not_finite_is_refused)
{
    for (int axis = 0; axis < 3; axis++) {
        LookAt view = look_at_of_the_deck();
        view.eye[axis] = not_finite(axis);
        look_refuses_also(view, FINITE, axis == 1 ? UP : 0);
        view = look_at_of_the_deck();
        view.at[axis] = not_finite(axis + 1);
        look_refuses_also(view, FINITE, axis == 1 ? UP : 0);
        view = look_at_of_the_deck();
        view.up[axis] = not_finite(axis + 2);
        look_refuses_also(view, FINITE, axis == 2 ? UP : 0);
    }
}
END_TEST

// NaN and minus infinity are not positive either, and an infinite aspect leaves no height.
START_TEST(a_width_or_aspect_that_is_not_finite_is_refused)
{
    for (int i = 0; i < 3; i++) {
        look_refuses(deck_with_size(not_finite(i), 1), FINITE | WIDTH | HEIGHT);
        look_refuses(deck_with_size(2, not_finite(i)), FINITE | HEIGHT);
        look_refuses(deck_with_size(0.2, not_finite(i)), FINITE | HEIGHT);
    }
}
END_TEST

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
START_TEST(at_90_degrees_the_plane_is_twice_as_wide_as_its_distance)
{
    expect_width(90, 1, 2);
    expect_width(90, 3.5, 7);
}
END_TEST

// By hand: eye and edges are an equilateral triangle, its height the distance.
START_TEST(at_60_degrees_the_plane_is_as_wide_as_the_distance_to_its_edges)
{
    expect_width(60, 1, 2 / sqrt(3));
    expect_width(60, sqrt(3), 2);
}
END_TEST

// By hand: the tangent of 22.5 degrees is sqrt(2) - 1, of 15 it is 2 - sqrt(3), of 60 sqrt(3).
START_TEST(at_30_45_and_120_degrees_the_tangents_are_known)
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
        given("seen", "the width at 6, from the width at 3");
        expect_number(width_from_angle(degrees[i], 6) / width_from_angle(degrees[i], 3), 2,
                      TOLERANCE);
    }
}
END_TEST

// At such angles an arc and its tangent are equal to 20 digits.
START_TEST(at_a_very_small_angle_the_width_is_the_length_of_the_arc)
{
    given_number("degrees", 1e-6);
    given_number("distance", 180e6);
    expect_number(width_from_angle(1e-6, 180e6), PI, TOLERANCE);
}
END_TEST

// The law of scale: the width grows with the distance.
START_TEST(the_width_grows_with_the_distance)
{
    enum { COUNT = 13 };
    for (int i = 0; i < COUNT; i++) {
        double distance = random_scale(i, COUNT) * random_number(1, 9);
        expect_width_of_size(90, distance, 2 * distance, distance);
    }
}
END_TEST

// For a small x the tangent is x + x^3 / 3 + 2 x^5 / 15 + 17 x^7 / 315.
START_TEST(at_any_small_angle_the_width_is_that_of_the_tangent_series)
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
START_TEST(seen_from_the_eye_the_edges_are_the_given_angle_apart)
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

static void list_tests(void)
{
    tests_of("camera_from_vectors");
    test(the_four_vectors_of_the_deck_give_its_camera);
    test(four_vectors_give_an_oblique_camera_of_either_hand);
    test(four_vectors_of_any_camera_give_it_back);
    test(four_vectors_keep_the_rays_to_twelve_digits);
    test(four_vectors_that_do_not_end_in_a_rectangle_are_refused);
    test(four_vectors_to_a_rectangle_not_straight_ahead_are_refused);
    test(four_vectors_that_leave_no_distance_width_or_height_are_refused);
    test(four_vectors_pushed_out_of_shape_or_place_are_refused);
    test(four_vectors_that_are_not_finite_are_refused);
    test(four_vectors_in_worlds_of_any_size_give_the_camera);
    test(four_vectors_of_an_invalid_camera_are_refused_in_worlds_of_any_size);
    tests_of("camera_from_points");
    test(the_four_points_of_the_deck_give_its_camera);
    test(four_points_give_an_oblique_camera_of_either_hand);
    test(four_points_of_any_camera_give_it_back);
    test(four_points_keep_the_rays_to_twelve_digits);
    test(four_points_that_are_not_a_rectangle_are_refused);
    test(four_points_of_a_rectangle_not_straight_ahead_are_refused);
    test(four_points_that_leave_no_distance_width_or_height_are_refused);
    test(four_points_pushed_out_of_shape_or_place_are_refused);
    test(four_points_that_are_not_finite_are_refused);
    test(four_points_in_worlds_of_any_size_give_the_camera);
    test(four_points_of_an_invalid_camera_are_refused_in_worlds_of_any_size);
    tests_of("camera_from_corner");
    test(the_corner_and_two_vectors_of_the_deck_give_its_camera);
    test(a_corner_and_two_vectors_give_an_oblique_camera_of_either_hand);
    test(the_corner_and_two_vectors_of_any_camera_give_it_back);
    test(a_corner_and_two_vectors_keep_the_rays_to_twelve_digits);
    test(two_vectors_that_are_not_at_right_angles_are_refused);
    test(a_corner_and_two_vectors_of_a_rectangle_not_straight_ahead_are_refused);
    test(a_corner_and_two_vectors_that_leave_no_distance_width_or_height_are_refused);
    test(a_corner_and_two_vectors_pushed_out_of_shape_or_place_are_refused);
    test(a_corner_and_two_vectors_that_are_not_finite_are_refused);
    test(a_corner_and_two_vectors_in_worlds_of_any_size_give_the_camera);
    test(corner_and_vectors_of_an_invalid_camera_are_refused_in_worlds_of_any_size);
    tests_of("camera_from_look_at");
    test(the_look_at_of_the_deck_gives_its_camera_in_a_left_handed_world);
    test(the_look_at_of_the_deck_is_mirrored_in_a_right_handed_world);
    test(along_minus_z_in_a_right_handed_world_x_is_to_the_right);
    test(an_oblique_look_at_in_a_world_of_either_hand);
    test(up_may_lean_and_have_any_length);
    test(up_may_lean_until_it_is_almost_along_the_view);
    test(the_height_is_the_width_divided_by_the_aspect);
    test(the_plane_passes_through_the_point_looked_at);
    test(the_look_at_of_any_camera_gives_it_back);
    test(a_look_at_in_worlds_of_any_size_gives_the_camera);
    test(a_look_at_keeps_the_rays_to_twelve_digits);
    test(looking_at_the_eye_itself_is_refused);
    test(an_up_of_zero_is_refused);
    test(an_up_along_the_view_is_refused);
    test(an_up_against_the_view_is_refused);
    test(a_width_that_is_not_positive_is_refused);
    test(an_aspect_that_is_not_positive_is_refused);
    test(a_look_at_whose_vectors_are_not_finite_is_refused);
    test(a_width_or_aspect_that_is_not_finite_is_refused);
    tests_of_extra("camera_from_look_at");
    test(up_may_be_almost_along_an_oblique_view);
    tests_of("width_from_angle");
    test(at_90_degrees_the_plane_is_twice_as_wide_as_its_distance);
    test(at_60_degrees_the_plane_is_as_wide_as_the_distance_to_its_edges);
    test(at_30_45_and_120_degrees_the_tangents_are_known);
    test(twice_as_far_away_is_twice_as_wide);
    test(at_a_very_small_angle_the_width_is_the_length_of_the_arc);
    test(the_width_grows_with_the_distance);
    test(at_any_small_angle_the_width_is_that_of_the_tangent_series);
    test(seen_from_the_eye_the_edges_are_the_given_angle_apart);
}

OF_STEM(list_tests)
