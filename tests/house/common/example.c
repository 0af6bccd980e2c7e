// example.c - tests of chapters/shared/example.c: the example is what the lecture needs, whatever
// its numbers.
#include "chapters/shared/example.h"

#include "tests/judge/test.h"

#include <math.h>

TEST(example_camera, it_is_a_camera)
{
    given_camera(example_camera());
    expect_fault(camera_check(example_camera()), CAMERA_OK);
}

TEST(example_place, the_place_is_on_the_image_plane)
{
    Normalized place = example_place();
    expect_pair(place.s, place.t, fmin(fmax(place.s, 0), 1), fmin(fmax(place.t, 0), 1), 0);
}

TEST(example_point, the_point_and_the_pixel_are_on_the_screen)
{
    Resolution screen = example_screen();
    Pixel pixel = example_pixel();
    given("screen", "%d x %d", screen.width, screen.height);
    expect_pair(example_point().x, example_point().y, pixel.column, pixel.row, 0);
    expect_law(pixel.column >= 0 && pixel.column < screen.width, "a column of the screen", "not");
    expect_law(pixel.row >= 0 && pixel.row < screen.height, "a row of the screen", "not");
}

// The centre is ahead of p, p is outside, and the line passes closer than the radius.
TEST(example_ray, the_ray_meets_the_sphere_twice_in_front_of_its_origin)
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
