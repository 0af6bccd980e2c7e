// 06-ray-casting-nearest.c - tests of nearest_hit.
#include "tests/06-ray-casting.h"

#include "exercises/04-pixel-ray.h"

void expect_nearest(Ray ray, const Scene *scene, double t, int sphere)
{
    given_scene(scene);
    given_ray(ray);
    given("looking at", "t");
    expect_number(nearest_hit(ray, scene).t, t, t == NO_HIT ? 0 : TOLERANCE * t);
    given_scene(scene);
    given_ray(ray);
    given("looking at", "the index of the sphere");
    expect_int(nearest_hit(ray, scene).sphere, sphere);
}

static Ray along_minus_z(double x, double y, double z)
{
    return (Ray){vec3_of(x, y, z), vec3_of(0, 0, -1)};
}

START_TEST(the_nearest_of_three_is_hit_in_any_order_of_the_scene)
{
    int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (int i = 0; i < 6; i++) {
        Sphere spheres[3];
        for (int place = 0; place < 3; place++)
            spheres[place] = sphere_at(0, 0, -4 - 3 * orders[i][place], 1, RED + place);
        Scene scene = scene_of(3, spheres);
        int first = orders[i][0] == 0 ? 0 : orders[i][1] == 0 ? 1 : 2;
        expect_nearest(along_minus_z(0, 0, 0), &scene, 3, first);
    }
}
END_TEST

START_TEST(of_equals_the_lower_index_is_hit)
{
    Sphere spheres[] = {sphere_at(0, 0, -9, 1, RED), sphere_at(0, 0, -5, 1, GREEN),
                        sphere_at(0, 0, -5, 1, BLUE), sphere_at(0, 0, -5, 1, WHITE)};
    Scene scene = scene_of(4, spheres);
    expect_nearest(along_minus_z(0, 0, 0), &scene, 4, 1);
}
END_TEST

START_TEST(what_is_behind_the_eye_is_not_hit)
{
    Sphere spheres[] = {sphere_at(0, 0, 3, 1, RED), sphere_at(0, 0, -5, 1, GREEN)};
    Scene both = scene_of(2, spheres), behind = scene_of(1, spheres);
    expect_nearest(along_minus_z(0, 0, 0), &both, 4, 1);
    expect_nearest(along_minus_z(0, 0, 0), &behind, NO_HIT, -1);
}
END_TEST

START_TEST(where_nothing_is_hit_there_is_no_hit_and_no_sphere)
{
    Sphere spheres[] = {sphere_at(5, 0, -5, 1, RED), sphere_at(-5, 0, -5, 1, GREEN)};
    Scene scene = scene_of(2, spheres);
    expect_nearest(along_minus_z(0, 0, 0), &scene, NO_HIT, -1);
}
END_TEST

START_TEST(in_an_empty_scene_nothing_is_hit)
{
    Scene scene = scene_of(0, NULL);
    expect_nearest(along_minus_z(0, 0, 0), &scene, NO_HIT, -1);
}
END_TEST

START_TEST(the_first_and_the_last_sphere_can_be_hit)
{
    Sphere spheres[] = {sphere_at(-3, 0, -5, 1, RED), sphere_at(0, 0, -5, 1, RED),
                        sphere_at(3, 0, -5, 1, RED)};
    Scene scene = scene_of(3, spheres);
    expect_nearest(along_minus_z(-3, 0, 0), &scene, 4, 0);
    expect_nearest(along_minus_z(3, 0, 0), &scene, 4, 2);
}
END_TEST

// The centre of the large one is farther, its surface is nearer: 10 - 8 against 5 - 1.
START_TEST(the_nearest_surface_counts_and_not_the_nearest_centre)
{
    Sphere spheres[] = {sphere_at(0, 0, -5, 1, RED), sphere_at(0, 0, -10, 8, GREEN)};
    Scene scene = scene_of(2, spheres);
    expect_nearest(along_minus_z(0, 0, 0), &scene, 2, 1);
}
END_TEST

START_TEST(t_counts_in_lengths_of_the_direction)
{
    Sphere spheres[] = {sphere_at(0, 0, -9, 1, RED), sphere_at(0, 0, -5, 1, GREEN)};
    Scene scene = scene_of(2, spheres);
    Ray ray = {vec3_of(0, 0, 0), vec3_of(0, 0, -8)};
    expect_nearest(ray, &scene, 0.5, 1);
    ray.direction = vec3_of(0, 0, -0.5);
    expect_nearest(ray, &scene, 8, 1);
    ray.direction = vec3_of(0, 0, -80);
    expect_nearest(ray, &scene, 0.05, 1);
    ray.direction = vec3_of(0, 0, -8000);
    expect_nearest(ray, &scene, 0.0005, 1);
}
END_TEST

// Green, round the eye, is left at t = 7; red stands inside it.
START_TEST(from_inside_a_sphere_its_far_side_is_hit_and_what_stands_before_it)
{
    Sphere spheres[] = {sphere_at(0, 0, 0, 7, GREEN), sphere_at(0, 3, -4, 1, RED)};
    Scene scene = scene_of(2, spheres);
    Ray ray = {vec3_of(0, 0, 0), vec3_of(0, -0.6, -0.8)};
    expect_nearest(ray, &scene, 7, 0);
    ray.direction = vec3_of(0, 0.6, -0.8);
    expect_nearest(ray, &scene, 4, 1);
}
END_TEST

// By hand, with rays along -z from z = 20: over (x, y) a sphere round (cx, cy, cz) reaches up to
// cz + sqrt(9 - (x - cx)^2 - (y - cy)^2).
START_TEST(where_spheres_of_the_deck_overlap_red_comes_first_then_green_then_blue)
{
    static const struct {
        double x, y, z;
        int sphere;
    } places[] = {
        {2, 0, 3.2360679774997897, 0}, // red 1 + sqrt 5, green sqrt 5
        {0, 1, 3, 0},                  // red 1 + 2, blue -1 + 2
        {0, -1, 2, 1},                 // green 2, blue -1 + 2
        {0, 0, 2, 0},                  // red 1 + 1, green 1, blue -1 + sqrt 5
    };
    Scene scene = scene_of_the_deck();
    for (int i = 0; i < 4; i++)
        expect_nearest(along_minus_z(places[i].x, places[i].y, 20), &scene, 20 - places[i].z,
                       places[i].sphere);
}
END_TEST

START_TEST(of_spheres_one_behind_the_other_the_nearest_is_hit)
{
    int hits = 0;
    for (int i = 0; i < 40 || hits < 10; i++) {
        Sphere spheres[SHELLS];
        Camera camera = random_camera();
        random_shells(camera, spheres);
        Scene scene = scene_of(SHELLS, spheres);
        Resolution size = {16, 9};
        Ray ray = pixel_ray(camera, size, random_pixel(size));
        int seen = shell_seen(ray.origin, ray.direction, SHELLS, spheres);
        if (seen == -2)
            continue;
        expect_nearest(ray, &scene, t_seen(ray, spheres, seen), seen);
        hits += seen >= 0;
    }
}
END_TEST

void list_tests_of_nearest_hit(void)
{
    tests_of("nearest_hit");
    test(the_nearest_of_three_is_hit_in_any_order_of_the_scene);
    test(of_equals_the_lower_index_is_hit);
    test(what_is_behind_the_eye_is_not_hit);
    test(where_nothing_is_hit_there_is_no_hit_and_no_sphere);
    test(in_an_empty_scene_nothing_is_hit);
    test(the_first_and_the_last_sphere_can_be_hit);
    test(the_nearest_surface_counts_and_not_the_nearest_centre);
    test(t_counts_in_lengths_of_the_direction);
    test(from_inside_a_sphere_its_far_side_is_hit_and_what_stands_before_it);
    test(where_spheres_of_the_deck_overlap_red_comes_first_then_green_then_blue);
    test(of_spheres_one_behind_the_other_the_nearest_is_hit);
    list_more_of_nearest_hit();
}
