// probes.c - calls that distinguish the mistakes of exercise 01: any cameras, and places on and
// beyond the plane.
#include "exercises/01-corners.h"

#include "tests/judge/suspects.h"
#include "tests/judge/test.h"

enum { MANY = 12 };

START_TEST(upper_left_of_any_camera)
{
    for (int i = 0; i < MANY; i++)
        upper_left(random_camera());
}
END_TEST

START_TEST(upper_right_of_any_camera)
{
    for (int i = 0; i < MANY; i++)
        upper_right(random_camera());
}
END_TEST

START_TEST(across_30_up_10_of_any_camera)
{
    for (int i = 0; i < MANY; i++)
        across_30_up_10(random_camera());
}
END_TEST

START_TEST(any_place_of_any_camera)
{
    for (int i = 0; i < 2 * MANY; i++) {
        Camera camera = random_camera();
        double s = random_number(-1, 2);
        image_plane_vector(camera, s, random_number(-1, 2));
    }
}
END_TEST

START_TEST(unit_distance_of_any_camera)
{
    for (int i = 0; i < 2 * MANY; i++) {
        Camera camera = random_camera();
        if (i % 2 == 0)
            camera.distance = random_number(0.1, 0.9);
        with_unit_distance(camera);
    }
}
END_TEST

static void list_probes(void)
{
    tests_of("upper_left");
    test(upper_left_of_any_camera);
    tests_of("upper_right");
    test(upper_right_of_any_camera);
    tests_of("across_30_up_10");
    test(across_30_up_10_of_any_camera);
    tests_of("image_plane_vector");
    test(any_place_of_any_camera);
    tests_of("with_unit_distance");
    test(unit_distance_of_any_camera);
}

OF_STEM(list_probes)
