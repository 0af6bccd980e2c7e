// 07-shading-scene-offset.c - tests of off_surface: how far, and to which side.
#include "tests/07-shading-scene.h"

#include <stdio.h>

// From a point of the sphere, straight to the side of the normal, by what the contract allows: any
// number from 2^-32 to 2^-28 of the size.
static void expect_off(Sphere sphere, vec3 point, vec3 normal, double size)
{
    const double rounding = 0x1p-46 * size;
    given_sphere(sphere);
    given_vec3("point", point);
    given_vec3("normal", normal);
    given("size", "%s", number_text_to(size, 10).s);
    vec3 moved = off_surface(sphere, point, normal) - point;
    double along = vec3_dot(moved, normal), aside = vec3_length(moved - along * normal);
    char expected[200];
    snprintf(expected, sizeof expected, "moved by %.24s to %.24s along the normal, and not aside",
             number_text_to(0x1p-32 * size, 3).s, number_text_to(0x1p-28 * size, 3).s);
    expect_law(along >= 0x1p-32 * size - rounding && along <= 0x1p-28 * size + rounding &&
                   aside <= rounding,
               expected, "moved by %.40s along the normal, by %.40s aside",
               number_text_to(along, 3).s, number_text_to(aside, 3).s);
}

static Sphere sphere_round(vec3 center, double radius)
{
    return (Sphere){.center = center, .radius = radius};
}

// So that the sphere touches the origin of the world, where the smallest step is seen.
static Sphere sphere_at_origin(vec3 outward, double radius)
{
    return sphere_round(-radius * outward, radius);
}

START_TEST(outside_the_point_moves_away_from_the_centre)
{
    vec3 up = vec3_of(0, 1, 0), back = vec3_of(0, 0, -1), aslant = vec3_of(0.6, 0, 0.8);
    expect_off(sphere_at_origin(up, 1000), vec3_of(0, 0, 0), up, 2000);
    expect_off(sphere_at_origin(back, 50000), vec3_of(0, 0, 0), back, 1e5);
    expect_off(sphere_at_origin(aslant, 1000), vec3_of(0, 0, 0), aslant, 1800);
}
END_TEST

START_TEST(inside_the_point_moves_towards_the_centre)
{
    vec3 up = vec3_of(0, 1, 0), aslant = vec3_of(0.6, -0.8, 0);
    expect_off(sphere_at_origin(-up, 1000), vec3_of(0, 0, 0), up, 2000);
    expect_off(sphere_at_origin(-aslant, 5000), vec3_of(0, 0, 0), aslant, 9000);
}
END_TEST

START_TEST(scenes_may_be_of_any_size)
{
    vec3 up = vec3_of(0, 1, 0);
    for (int i = -9; i <= 9; i++) {
        double radius = pow(10, i);
        expect_off(sphere_at_origin(up, radius), vec3_of(0, 0, 0), up, 2 * radius);
        expect_off(sphere_at_origin(-up, radius), vec3_of(0, 0, 0), up, 2 * radius);
    }
}
END_TEST

// The farther from the origin of the world, the coarser are the numbers there.
START_TEST(a_small_sphere_far_away_needs_as_large_a_step_as_a_large_one)
{
    vec3 up = vec3_of(0, 1, 0);
    for (int i = 0; i < 3; i++) {
        vec3 center = vec3_of(0, -1, 0);
        center[i] += 1e6;
        vec3 point = center + up;
        expect_off(sphere_round(center, 1), point, up, (i == 1 ? 1e6 - 1 : 1e6) + 1);
    }
    // Fractions count as well.
    for (int i = 0; i < 3; i++) {
        vec3 center = vec3_of(0, 0, 0);
        center[i] = 0.9;
        expect_off(sphere_round(center, 0x1p-10), center + 0x1p-10 * up, up, 0.9 + 0x1p-10);
    }
    expect_off(sphere_round(vec3_of(0, 0, 0), 0.9), 0.9 * up, up, 0.9);
}
END_TEST

START_TEST(negative_coordinates_are_as_large_as_positive_ones)
{
    vec3 up = vec3_of(0, 1, 0);
    for (int i = 0; i < 3; i++) {
        vec3 center = vec3_of(0, -1, 0);
        center[i] -= 1e6;
        expect_off(sphere_round(center, 1), center + up, up, (i == 1 ? 1e6 + 1 : 1e6) + 1);
    }
}
END_TEST

START_TEST(round_the_origin_of_the_world_the_radius_counts)
{
    vec3 up = vec3_of(0, 1, 0);
    expect_off(sphere_round(-2.5e5 * up, 1e6), 7.5e5 * up, up, 1.25e6);
    expect_off(sphere_round(vec3_of(0, 0, 0), 1e6), vec3_of(0, 0, 1e6), vec3_of(0, 0, 1), 1e6);
    expect_off(sphere_round(vec3_of(0, 0, 0), 7e5), vec3_of(2e5, 3e5, 6e5), vec3_of(2, 3, 6) / 7,
               7e5);
}
END_TEST

START_TEST(anywhere_it_is_a_step_along_the_normal)
{
    for (int i = 0; i < 30; i++) {
        double scale = random_size(1e8);
        Sphere sphere = random_sphere(3 * scale, 0.1 * scale, 3 * scale);
        vec3 outward = random_unit(), c = sphere.center;
        if (i % 3 == 0)
            sphere.center = c = -sphere.radius * outward;
        double size = sphere.radius + fmax(fabs(c[0]), fmax(fabs(c[1]), fabs(c[2])));
        vec3 point = c + sphere.radius * outward;
        expect_off(sphere, point, i % 2 == 0 ? outward : -outward, size);
    }
}
END_TEST

void list_tests_of_off_surface(void)
{
    tests_of("off_surface");
    test(outside_the_point_moves_away_from_the_centre);
    test(inside_the_point_moves_towards_the_centre);
    test(scenes_may_be_of_any_size);
    test(a_small_sphere_far_away_needs_as_large_a_step_as_a_large_one);
    test(negative_coordinates_are_as_large_as_positive_ones);
    test(round_the_origin_of_the_world_the_radius_counts);
    test(anywhere_it_is_a_step_along_the_normal);
}
