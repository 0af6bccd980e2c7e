// camera.c - tests of common/camera.c: what is a camera, and the reason where it is none.
// Expected: the contract in common/camera.h, and the deck's own camera.
#include "common/camera.h"

#include "tests/judge/test.h"

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

TEST(camera_of_the_deck, the_camera_of_the_deck_is_a_left_handed_camera)
{
    Camera c = camera_of_the_deck();
    expect_check(c, CAMERA_OK);
    expect_vec3(vec3_cross(c.up, c.forward), c.right, 0);
}

TEST(camera_check, a_camera_of_either_hand_is_fine)
{
    Camera c = oblique_camera();
    expect_check(c, CAMERA_OK);
    c.right = -c.right;
    expect_check(c, CAMERA_OK);
    for (int i = 0; i < 100; i++)
        expect_check(random_camera(), CAMERA_OK);
}

TEST(camera_check, every_number_of_a_camera_must_be_finite)
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

TEST(camera_check, each_direction_must_be_unit_to_1e_minus_9)
{
    // Rounding may leave a length 1e-10 off.
    const double factors[] = {1 + 1e-8, 1 - 1e-8, 2, 0.5, 0, 1e200, 1e-200, 1 + 1e-10, 1 - 1e-10};
    for (int i = 0; i < 9; i++)
        for (int k = 0; k < 3; k++) {
            Camera c = oblique_camera();
            vec3 *directions[] = {&c.right, &c.up, &c.forward};
            *directions[k] *= factors[i];
            given_number("times", factors[i]);
            expect_check(c, i < 7 ? CAMERA_NOT_UNIT : CAMERA_OK);
        }
}

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

TEST(camera_check, each_pair_of_directions_must_be_at_right_angles_to_1e_minus_9)
{
    turn_each_towards_each(1e-8, CAMERA_NOT_PERPENDICULAR);
    turn_each_towards_each(-1e-8, CAMERA_NOT_PERPENDICULAR);
    turn_each_towards_each(PI / 2, CAMERA_NOT_PERPENDICULAR);
    turn_each_towards_each(1e-10, CAMERA_OK);
    turn_each_towards_each(-1e-10, CAMERA_OK);
}

TEST(camera_check, distance_width_and_height_must_be_positive)
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
