// 02-cameras-vectors.c - tests of eye and four vectors.
#include "tests/02-cameras.h"

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

START_TEST(four_vectors_that_end_in_no_rectangle_are_refused)
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

START_TEST(four_vectors_that_give_no_camera_are_refused_in_worlds_of_any_size)
{
    refuses_in_worlds_of_any_size(VECTORS);
}
END_TEST

void list_tests_of_vectors(void)
{
    tests_of("camera_from_vectors");
    test(the_four_vectors_of_the_deck_give_its_camera);
    test(four_vectors_give_an_oblique_camera_of_either_hand);
    test(four_vectors_of_any_camera_give_it_back);
    test(four_vectors_keep_the_rays_to_twelve_digits);
    test(four_vectors_that_end_in_no_rectangle_are_refused);
    test(four_vectors_to_a_rectangle_not_straight_ahead_are_refused);
    test(four_vectors_that_leave_no_distance_width_or_height_are_refused);
    test(four_vectors_pushed_out_of_shape_or_place_are_refused);
    test(four_vectors_that_are_not_finite_are_refused);
    test(four_vectors_in_worlds_of_any_size_give_the_camera);
    test(four_vectors_that_give_no_camera_are_refused_in_worlds_of_any_size);
}
