// camera.c - tests of common/camera.c: what is a camera, and the reason where it is none.
// Expected: the contract in common/camera.h, and the deck's own camera.
#include "common/camera.h"

#include "tests/judge/test.h"

#include <string.h>

// No two numbers are alike. Left-handed: right x up = forward.
static Camera oblique_camera(void)
{
    return (Camera){.origin = vec3_of(3, -5, 7),
                    .right = vec3_of(2, -2, 1) / 3,
                    .up = vec3_of(2, 1, -2) / 3,
                    .forward = vec3_of(1, 2, 2) / 3,
                    .distance = 6,
                    .width = 9,
                    .height = 3};
}

static void expect_check(Camera camera, CameraFault expected)
{
    given_camera(camera);
    expect_fault(camera_check(camera), expected);
}

START_TEST(the_camera_of_the_deck_is_a_left_handed_camera)
{
    Camera c = camera_of_the_deck();
    expect_check(c, CAMERA_OK);
    expect_vec3(vec3_cross(c.up, c.forward), c.right, 0);
}
END_TEST

START_TEST(a_camera_of_either_hand_is_fine)
{
    Camera c = oblique_camera();
    expect_check(c, CAMERA_OK);
    c.right = -c.right;
    expect_check(c, CAMERA_OK);
    for (int i = 0; i < 100; i++)
        expect_check(random_camera(), CAMERA_OK);
}
END_TEST

START_TEST(every_number_of_a_camera_must_be_finite)
{
    const double bad[] = {NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 12; k++) {
            Camera c = oblique_camera();
            vec3 *vectors[] = {&c.origin, &c.right, &c.up, &c.forward};
            (*vectors[k / 3])[k % 3] = bad[i];
            expect_check(c, CAMERA_NOT_FINITE);
        }
        for (int k = 0; k < 3; k++) {
            Camera c = oblique_camera();
            double *numbers[] = {&c.distance, &c.width, &c.height};
            *numbers[k] = bad[i];
            expect_check(c, CAMERA_NOT_FINITE);
        }
    }
}
END_TEST

START_TEST(each_direction_must_be_unit_to_1e_minus_9)
{
    const double factors[] = {1 + 1e-8, 1 - 1e-8, 2, 0.5, 0, 1e200, 1e-200};
    for (int i = 0; i < 7; i++)
        for (int k = 0; k < 3; k++) {
            Camera c = oblique_camera();
            vec3 *directions[] = {&c.right, &c.up, &c.forward};
            *directions[k] *= factors[i];
            given_number("times", factors[i]);
            expect_check(c, CAMERA_NOT_UNIT);
        }
}
END_TEST

START_TEST(a_length_that_rounding_left_1e_minus_10_off_is_fine)
{
    for (int sign = -1; sign <= 1; sign += 2)
        for (int k = 0; k < 3; k++) {
            Camera c = oblique_camera();
            vec3 *directions[] = {&c.right, &c.up, &c.forward};
            *directions[k] *= 1 + sign * 1e-10;
            expect_check(c, CAMERA_OK);
        }
}
END_TEST

// Turns each of the three directions by a small angle towards each of the other two.
static void turn_each_towards_each(double angle, CameraFault expected)
{
    for (int k = 0; k < 9; k++) {
        Camera c = oblique_camera();
        vec3 *directions[] = {&c.right, &c.up, &c.forward};
        if (k / 3 == k % 3)
            continue;
        *directions[k / 3] = cos(angle) * *directions[k / 3] + sin(angle) * *directions[k % 3];
        given_number("radians", angle);
        given("turned", "direction %d towards %d", k / 3, k % 3);
        expect_check(c, expected);
    }
}

START_TEST(each_pair_of_directions_must_be_at_right_angles_to_1e_minus_9)
{
    turn_each_towards_each(1e-8, CAMERA_NOT_PERPENDICULAR);
    turn_each_towards_each(-1e-8, CAMERA_NOT_PERPENDICULAR);
    turn_each_towards_each(PI / 2, CAMERA_NOT_PERPENDICULAR);
}
END_TEST

START_TEST(an_angle_that_rounding_left_1e_minus_10_off_is_fine)
{
    turn_each_towards_each(1e-10, CAMERA_OK);
    turn_each_towards_each(-1e-10, CAMERA_OK);
}
END_TEST

START_TEST(distance_width_and_height_must_be_positive)
{
    const double bad[] = {0, -0.0, -1, -1e-300, -1e300};
    const CameraFault faults[] = {CAMERA_NO_DISTANCE, CAMERA_NO_WIDTH, CAMERA_NO_HEIGHT};
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 3; k++) {
            Camera c = oblique_camera();
            double *numbers[] = {&c.distance, &c.width, &c.height};
            *numbers[k] = bad[i];
            expect_check(c, faults[k]);
            *numbers[k] = 1e-300;
            expect_check(c, CAMERA_OK);
        }
}
END_TEST

START_TEST(of_several_reasons_the_first_is_given)
{
    Camera c = {.distance = NAN};
    expect_check(c, CAMERA_NOT_FINITE);
    c.distance = 0;
    expect_check(c, CAMERA_NOT_UNIT);
    c.right = c.up = c.forward = vec3_of(1, 0, 0);
    expect_check(c, CAMERA_NOT_PERPENDICULAR);
    c.up = vec3_of(0, 1, 0);
    c.forward = vec3_of(0, 0, 1);
    expect_check(c, CAMERA_NO_DISTANCE);
    c.distance = 1;
    expect_check(c, CAMERA_NO_WIDTH);
    c.width = 1;
    expect_check(c, CAMERA_NO_HEIGHT);
}
END_TEST

// The word that a reader looks for in each reason.
START_TEST(every_reason_has_words_of_its_own)
{
    static const char *const words[CAMERA_FAULTS] = {
        [CAMERA_OK] = "nothing",           [CAMERA_NOT_FINITE] = "infinite",
        [CAMERA_NOT_UNIT] = "length 1",    [CAMERA_NOT_PERPENDICULAR] = "right angles",
        [CAMERA_NO_DISTANCE] = "distance", [CAMERA_NO_WIDTH] = "width",
        [CAMERA_NO_HEIGHT] = "height",     [CAMERA_NO_DIRECTION] = "same",
        [CAMERA_UP_ALONG_VIEW] = "up",     [CAMERA_NO_RECTANGLE] = "rectangle",
        [CAMERA_OFF_AXIS] = "eye",
    };
    for (int i = 0; i < CAMERA_FAULTS; i++) {
        const char *text = camera_fault_text((CameraFault)i);
        given("reason", "number %d", i);
        expect_law(strstr(text, words[i]) != NULL, words[i], "%s", text);
        for (int k = 0; k < i; k++)
            ck_assert_str_ne(text, camera_fault_text((CameraFault)k));
    }
}
END_TEST

START_TEST(a_reason_that_there_is_not_has_words_too)
{
    const int numbers[] = {-1, -1000, CAMERA_FAULTS, 999, 2147483647};
    for (int i = 0; i < 5; i++) {
        given("reason", "number %d", numbers[i]);
        expect_text(camera_fault_text((CameraFault)numbers[i]), "(no such reason)");
    }
}
END_TEST

static void list_tests(void)
{
    tests_of("camera_of_the_deck");
    test(the_camera_of_the_deck_is_a_left_handed_camera);
    tests_of("camera_check");
    test(a_camera_of_either_hand_is_fine);
    test(every_number_of_a_camera_must_be_finite);
    test(each_direction_must_be_unit_to_1e_minus_9);
    test(a_length_that_rounding_left_1e_minus_10_off_is_fine);
    test(each_pair_of_directions_must_be_at_right_angles_to_1e_minus_9);
    test(an_angle_that_rounding_left_1e_minus_10_off_is_fine);
    test(distance_width_and_height_must_be_positive);
    test(of_several_reasons_the_first_is_given);
    tests_of("camera_fault_text");
    test(every_reason_has_words_of_its_own);
    test(a_reason_that_there_is_not_has_words_too);
}

OF_STEM(list_tests)
