// example.c - tests of common/example.c: the example is what the lecture needs, whatever its
// numbers.
#include "common/example.h"

#include "chapters/example.h"
#include "tests/judge/test.h"

#include <math.h>

START_TEST(the_camera_has_the_numbers_of_the_file)
{
    Camera c = example_camera();
    expect_vec3(c.origin, vec3_of(EXAMPLE_EYE), 0);
    expect_vec3(c.right, vec3_of(EXAMPLE_RIGHT), 0);
    expect_vec3(c.up, vec3_of(EXAMPLE_UP), 0);
    expect_vec3(c.forward, vec3_of(EXAMPLE_FORWARD), 0);
    expect_number(c.distance, EXAMPLE_DISTANCE, 0);
    expect_number(c.width, EXAMPLE_WIDTH, 0);
    expect_number(c.height, EXAMPLE_HEIGHT, 0);
}
END_TEST

START_TEST(it_is_a_camera)
{
    given_camera(example_camera());
    expect_fault(camera_check(example_camera()), CAMERA_OK);
}
END_TEST

START_TEST(the_place_is_on_the_image_plane)
{
    Normalized place = example_place();
    expect_pair(place.s, place.t, fmin(fmax(place.s, 0), 1), fmin(fmax(place.t, 0), 1), 0);
}
END_TEST

START_TEST(the_point_and_the_pixel_are_on_the_screen)
{
    Resolution screen = example_screen();
    Pixel pixel = example_pixel();
    given("screen", "%d x %d", screen.width, screen.height);
    expect_pair(example_point().x, example_point().y, pixel.column, pixel.row, 0);
    expect_law(pixel.column >= 0 && pixel.column < screen.width, "a column of the screen", "not");
    expect_law(pixel.row >= 0 && pixel.row < screen.height, "a row of the screen", "not");
}
END_TEST

// The centre is ahead of p, p is outside, and the line passes closer than the radius.
START_TEST(the_ray_meets_the_sphere_twice_in_front_of_its_origin)
{
    Ray ray = example_ray();
    Sphere sphere = example_sphere();
    vec3 to_center = sphere.center - ray.origin, unit = vec3_unit(ray.direction);
    double ahead = vec3_dot(to_center, unit);
    given_ray(ray);
    given_sphere(sphere);
    expect_law(ahead > 0, "ahead", "behind");
    expect_law(vec3_length(to_center) > sphere.radius, "from outside", "from inside");
    expect_law(vec3_length(to_center - ahead * unit) < sphere.radius, "two hits", "none");
}
END_TEST

static void list_tests(void)
{
    tests_of("example_camera");
    test(the_camera_has_the_numbers_of_the_file);
    test(it_is_a_camera);
    tests_of("example_place");
    test(the_place_is_on_the_image_plane);
    tests_of("example_point");
    test(the_point_and_the_pixel_are_on_the_screen);
    tests_of("example_ray");
    test(the_ray_meets_the_sphere_twice_in_front_of_its_origin);
}

OF_STEM(list_tests)
