// 07-shading-vectors.c - tests of the ways that light takes: normal, towards the light, mirrored.
#include "tests/07-shading.h"

// ---- surface_normal -----------------------------------------------------------------------------

void expect_normal(Sphere sphere, vec3 point, vec3 normal)
{
    given_sphere(sphere);
    given_vec3("point", point);
    expect_vec3(surface_normal(sphere, point), normal, TOLERANCE);
}

START_TEST(at_the_top_of_a_sphere_the_normal_points_up)
{
    expect_normal(sphere_at(0, 0, 0, 1), vec3_of(0, 1, 0), vec3_of(0, 1, 0));
    expect_normal(sphere_at(1, 2, -3, 1), vec3_of(1, 3, -3), vec3_of(0, 1, 0));
    expect_normal(sphere_at(1, 2, -3, 4), vec3_of(1, 6, -3), vec3_of(0, 1, 0));
}
END_TEST

START_TEST(on_opposite_sides_the_normals_are_opposite)
{
    expect_normal(sphere_at(5, 0, -7, 2), vec3_of(7, 0, -7), vec3_of(1, 0, 0));
    expect_normal(sphere_at(5, 0, -7, 2), vec3_of(3, 0, -7), vec3_of(-1, 0, 0));
}
END_TEST

// (2, 3, 6) is 7 long.
START_TEST(a_normal_is_unit_however_large_the_sphere)
{
    vec3 normal = vec3_of(2, 3, 6) / 7;
    expect_normal(sphere_at(4, -1, 2, 7), vec3_of(6, 2, 8), normal);
    expect_normal(sphere_at(4, -1, 2, 700), vec3_of(204, 299, 602), normal);
    expect_normal(sphere_at(4, -1, 2, 0.07), vec3_of(4.02, -0.97, 2.06), normal);
}
END_TEST

START_TEST(a_normal_that_was_chosen_comes_back)
{
    for (int i = 0; i < 20; i++) {
        Sphere sphere = random_sphere(9, 0.1, 5);
        vec3 normal = random_unit();
        expect_normal(sphere, sphere.center + sphere.radius * normal, normal);
    }
}
END_TEST

// ---- ray_to_light -------------------------------------------------------------------------------

void expect_ray_to_light(vec3 from, Light light, vec3 direction)
{
    Ray ray = ray_to_light(from, light);
    double tolerance = TOLERANCE * fmax(largest(from), largest(light.position));
    given_vec3("from", from);
    given_light(light);
    given("looking at", "the origin");
    expect_vec3(ray.origin, from, tolerance);
    given_vec3("from", from);
    given_light(light);
    given("looking at", "the direction");
    expect_vec3(ray.direction, direction, tolerance);
}

static Light light_of(LightKind kind, vec3 position)
{
    return (Light){position, {0.9, 0.7, 0.8}, kind};
}

START_TEST(a_point_light_is_reached_at_t_1)
{
    Light light = light_of(LIGHT_POINT, vec3_of(4, 6, 3));
    expect_ray_to_light(vec3_of(1, 2, 3), light, vec3_of(3, 4, 0));
    expect_ray_to_light(vec3_of(0, 0, 0), light, vec3_of(4, 6, 3));
    expect_ray_to_light(vec3_of(5, 6, -4), light, vec3_of(-1, 0, 7));
}
END_TEST

START_TEST(a_distant_light_has_one_direction_from_everywhere)
{
    Light light = light_of(LIGHT_DISTANT, vec3_of(1, 3, -2));
    expect_ray_to_light(vec3_of(1, 2, 3), light, vec3_of(1, 3, -2));
    expect_ray_to_light(vec3_of(-50, 4, 70), light, vec3_of(1, 3, -2));
    expect_ray_to_light(vec3_of(0, 0, 0), light, vec3_of(1, 3, -2));
}
END_TEST

START_TEST(the_way_to_a_light_that_was_put_somewhere_comes_back)
{
    for (int i = 0; i < 20; i++) {
        vec3 from = random_vec3(-9, 9), way = random_unit();
        way *= random_number(0.5, 9);
        expect_ray_to_light(from, light_of(LIGHT_POINT, from + way), way);
        expect_ray_to_light(from, light_of(LIGHT_DISTANT, way), way);
    }
}
END_TEST

// ---- mirror_direction ---------------------------------------------------------------------------

void expect_mirrored(vec3 direction, vec3 normal, vec3 mirrored)
{
    given_vec3("direction", direction);
    given_vec3("normal", normal);
    expect_vec3(mirror_direction(direction, normal), mirrored, TOLERANCE * vec3_length(direction));
}

static const vec3 up = {0, 1, 0};

START_TEST(what_falls_straight_on_comes_straight_back)
{
    expect_mirrored(vec3_of(0, -1, 0), up, vec3_of(0, 1, 0));
    expect_mirrored(vec3_of(-2, -3, -6), vec3_of(2, 3, 6) / 7, vec3_of(2, 3, 6));
}
END_TEST

START_TEST(what_comes_down_at_a_slant_goes_on_and_up)
{
    expect_mirrored(vec3_of(1, -1, 0), up, vec3_of(1, 1, 0));
    expect_mirrored(vec3_of(3, -4, 12), up, vec3_of(3, 4, 12));
    expect_mirrored(vec3_of(3, -4, 12), vec3_of(-1, 0, 0), vec3_of(-3, -4, 12));
}
END_TEST

START_TEST(what_runs_along_the_mirror_runs_on)
{
    expect_mirrored(vec3_of(2, 0, 1), up, vec3_of(2, 0, 1));
}
END_TEST

// By hand: (3, 3, -3) goes 3 along (2, 2, 1) / 3, so twice that, (4, 4, 2), is taken off.
START_TEST(a_mirror_that_stands_askew)
{
    expect_mirrored(vec3_of(3, 3, -3), vec3_of(-2, -2, -1) / 3, vec3_of(-1, -1, -5));
    expect_mirrored(vec3_of(1, 1, 5), vec3_of(-2, -2, -1) / 3, vec3_of(-3, -3, 3));
}
END_TEST

START_TEST(a_mirror_has_two_sides)
{
    expect_mirrored(vec3_of(1, 1, 0), up, vec3_of(1, -1, 0));
    expect_mirrored(vec3_of(3, 3, -3), vec3_of(2, 2, 1) / 3, vec3_of(-1, -1, -5));
}
END_TEST

START_TEST(the_part_along_the_normal_turns_round_and_the_part_across_it_stays)
{
    for (int i = 0; i < 20; i++) {
        vec3 normal = random_unit(), across = random_across(normal);
        vec3 along = random_number(-5, 5) * normal;
        across *= random_number(0.5, 5);
        expect_mirrored(along + across, normal, across - along);
    }
}
END_TEST

void list_tests_of_vectors(void)
{
    tests_of("surface_normal");
    test(at_the_top_of_a_sphere_the_normal_points_up);
    test(on_opposite_sides_the_normals_are_opposite);
    test(a_normal_is_unit_however_large_the_sphere);
    test(a_normal_that_was_chosen_comes_back);
    list_more_of_surface_normal();

    tests_of("ray_to_light");
    test(a_point_light_is_reached_at_t_1);
    test(a_distant_light_has_one_direction_from_everywhere);
    test(the_way_to_a_light_that_was_put_somewhere_comes_back);
    list_more_of_ray_to_light();

    tests_of("mirror_direction");
    test(what_falls_straight_on_comes_straight_back);
    test(what_comes_down_at_a_slant_goes_on_and_up);
    test(what_runs_along_the_mirror_runs_on);
    test(a_mirror_that_stands_askew);
    test(a_mirror_has_two_sides);
    test(the_part_along_the_normal_turns_round_and_the_part_across_it_stays);
    list_more_of_mirror_direction();
}
