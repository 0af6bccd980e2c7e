// 02-cameras-points.c - tests of eye and four points.
#include "tests/02-cameras.h"

// The deck draws the plane at z = 0, with x and y from 1 to 3.
START_TEST(the_four_points_of_the_deck_give_its_camera)
{
    vec3 in[] = {{2, 2, -4}, {1, 3, 0}, {3, 3, 0}, {1, 1, 0}, {3, 1, 0}};
    finds(POINTS, in, camera_of_the_deck());
}
END_TEST

// By hand: the four vectors above, from the eye on.
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

START_TEST(four_points_that_are_no_rectangle_are_refused)
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

START_TEST(four_points_that_give_no_camera_are_refused_in_worlds_of_any_size)
{
    refuses_in_worlds_of_any_size(POINTS);
}
END_TEST

void list_tests_of_points(void)
{
    tests_of("camera_from_points");
    test(the_four_points_of_the_deck_give_its_camera);
    test(four_points_give_an_oblique_camera_of_either_hand);
    test(four_points_of_any_camera_give_it_back);
    test(four_points_keep_the_rays_to_twelve_digits);
    test(four_points_that_are_no_rectangle_are_refused);
    test(four_points_of_a_rectangle_not_straight_ahead_are_refused);
    test(four_points_that_leave_no_distance_width_or_height_are_refused);
    test(four_points_pushed_out_of_shape_or_place_are_refused);
    test(four_points_that_are_not_finite_are_refused);
    test(four_points_in_worlds_of_any_size_give_the_camera);
    test(four_points_that_give_no_camera_are_refused_in_worlds_of_any_size);
}
