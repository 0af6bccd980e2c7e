// 06-ray-casting-depth.c - tests of object order: its depth, and that image order agrees.
#include "tests/06-ray-casting.h"

START_TEST(what_is_in_the_depth_before_does_not_matter)
{
    // The white one is seen by the pixel that would come behind the last.
    Sphere spheres[] = {sphere_at(10, 0, -10, 2, GREEN), sphere_at(0, 0, -10, 2, RED),
                        sphere_at(0, 0, -20, 2, BLUE), sphere_at(-10, -10, -10, 2, WHITE)};
    Scene scene = scene_of(4, spheres);
    Resolution size = {3, 1};
    Image expected = image_of(size), image = odd_image(size);
    image_set(&expected, (Pixel){0, 0}, scene.background);
    image_set(&expected, (Pixel){1, 0}, surfaces[RED].color);
    image_set(&expected, (Pixel){2, 0}, surfaces[GREEN].color);
    const double junk[] = {NAN, 0, -1, 1e-300, -INFINITY, 9};
    for (int i = 0; i < 6; i++) {
        double depth[] = {junk[i], junk[i], junk[i], 1e9};
        given_scene(&scene);
        given_size(size);
        given("depth", "%g everywhere before", junk[i]);
        cast_object_order(&scene, camera_with_pixels_of_1(size), &image, depth);
        expect_same_image(&image, &expected);
        given("looking at", "what is behind the last depth");
        expect_number(depth[3], 1e9, 0);
    }
    image_free(&expected);
    image_free(&image);
}
END_TEST

static bool is_near(double depth, double t)
{
    return depth == t || (t < NO_HIT && fabs(depth - t) <= TOLERANCE * t);
}

// One call, and one pixel of it is looked at: the first that is not as expected.
void expect_depths(const Scene *scene, Camera camera, Resolution size, const double *expected)
{
    double depth[MOST_PIXELS];
    int pixels = size.width * size.height, i = 0;
    for (int k = 0; k < pixels; k++)
        depth[k] = NAN;
    given_scene(scene);
    given_camera(camera);
    given_size(size);
    Image image = odd_image(size);
    cast_object_order(scene, camera, &image, depth);
    image_free(&image);
    while (i < pixels - 1 && is_near(depth[i], expected[i]))
        i++;
    given("looking at", "the depth of column %d, row %d", i % size.width, i / size.width);
    expect_number(depth[i], expected[i], expected[i] == NO_HIT ? 0 : TOLERANCE * expected[i]);
}

// 10 - 2, where the pixel's direction is 1 long; the plane is 1 away.
START_TEST(the_depth_straight_ahead_is_the_t_of_the_nearest_hit)
{
    Sphere spheres[] = {sphere_at(0, 0, -30, 2, BLUE), sphere_at(0, 0, -10, 2, RED),
                        sphere_at(0, 0, -20, 2, GREEN)};
    double expected[15];
    for (int i = 0; i < 15; i++)
        expected[i] = i == 7 ? 8 : NO_HIT;
    Scene scene = scene_of(3, spheres);
    Resolution size = {5, 3};
    expect_depths(&scene, camera_with_pixels_of_1(size), size, expected);
}
END_TEST

// On the plane, 4 away, the centres of the pixels are -3, 0, 3 each way: directions beside the
// middle are 5 long. Red is 10 - 1 away, green 20 - 5, blue 15 - 2.5.
START_TEST(the_depth_goes_row_by_row_and_counts_in_lengths_of_the_direction)
{
    Sphere spheres[] = {sphere_at(-6, 0, -8, 1, RED), sphere_at(0, 12, -16, 5, GREEN),
                        sphere_at(9, 0, -12, 2.5, BLUE)};
    const double expected[] = {NO_HIT, 3, NO_HIT, 1.8, NO_HIT, 2.5, NO_HIT, NO_HIT, NO_HIT};
    Scene scene = scene_of(3, spheres);
    Resolution size = {3, 3};
    Camera camera = camera_with_pixels_of_1(size);
    camera.distance = 4;
    camera.width = camera.height = 9;
    expect_depths(&scene, camera, size, expected);
}
END_TEST

START_TEST(the_depth_of_spheres_one_behind_the_other_is_that_of_the_nearest)
{
    for (int i = 0; i < 6; i++) {
        Sphere spheres[SHELLS];
        Resolution size = {5, 3};
        Camera camera = shells_behind(size, random_pixel(size), spheres);
        expect_depths_of_shells(camera, size, spheres);
    }
}
END_TEST

START_TEST(where_there_is_nothing_every_depth_is_no_hit)
{
    Scene scene = scene_of(0, NULL);
    Resolution size = {2, 2};
    const double expected[] = {NO_HIT, NO_HIT, NO_HIT, NO_HIT};
    expect_depths(&scene, camera_with_pixels_of_1(size), size, expected);
}
END_TEST

// Spheres that overlap and pass through each other, some twice, in two colours: ties.
START_TEST(both_orders_give_the_same_bytes)
{
    Resolution size = {24, 17};
    for (int i = 0; i < 6; i++) {
        enum { COUNT = SURFACES };
        Camera camera = random_camera();
        Sphere spheres[COUNT];
        for (int k = 0; k < COUNT; k++) {
            vec3 place = camera.origin + random_number(-2, 12) * camera.forward;
            spheres[k] = (Sphere){.center = place + random_vec3(-3, 3),
                                  .radius = random_number(0.1, 1),
                                  .surface = RED + k % 4};
            if (k % 5 == 4) {
                spheres[k].center = spheres[k - 1].center;
                spheres[k].radius = spheres[k - 1].radius;
            }
        }
        Scene scene = scene_of(COUNT, spheres);
        Image by_pixel = odd_image(size), by_sphere = odd_image(size);
        given_scene(&scene);
        given_camera(camera);
        given_size(size);
        given("compared", "with what image order gives");
        image_order(&scene, camera, &by_pixel);
        object_order(&scene, camera, &by_sphere);
        expect_same_image(&by_sphere, &by_pixel);
        image_free(&by_pixel);
        image_free(&by_sphere);
    }
}
END_TEST

void list_tests_of_depth(void)
{
    tests_of("cast_object_order");
    test(what_is_in_the_depth_before_does_not_matter);
    test(the_depth_straight_ahead_is_the_t_of_the_nearest_hit);
    test(the_depth_goes_row_by_row_and_counts_in_lengths_of_the_direction);
    test(the_depth_of_spheres_one_behind_the_other_is_that_of_the_nearest);
    test(where_there_is_nothing_every_depth_is_no_hit);
    test(both_orders_give_the_same_bytes);
    list_more_of_cast_object_order();
}
