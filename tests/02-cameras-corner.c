// 02-cameras-corner.c - tests of eye, lower left corner and two vectors.
#include "tests/02-cameras.h"

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

START_TEST(a_corner_and_two_vectors_that_give_no_camera_are_refused_in_worlds_of_any_size)
{
    refuses_in_worlds_of_any_size(CORNER);
}
END_TEST

void list_tests_of_corner(void)
{
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
    test(a_corner_and_two_vectors_that_give_no_camera_are_refused_in_worlds_of_any_size);
}
