// 07-shading-scene-trace.c - tests of trace_ray: mirrors, and how deep to look into them.
//
// Expected: mirrors on an axis, which send rays to and fro; mirrored directions with sides 3, 4, 5
// and 7, 24, 25; and random mirrors in long double. What is seen in a mirror must not depend on how
// far a right answer goes off its surface, so where mirrors are curved colours are ambient only.
#include "tests/07-shading-scene.h"

static const Color green = {0.2, 0.9, 0.3}, pink = {0.9, 0.4, 0.6}, white = {1, 1, 1};

static World world;

static Surface mirror(Color color, double specular)
{
    return surface_of(color, 0.5, specular, 3);
}

static Color ambient_of(int sphere)
{
    const Surface *surface = scene_surface(&world.scene, sphere);
    return surface->diffuse * surface->color * world.scene.ambient;
}

// What a sphere looks like from where the light is, straight ahead.
static Color lit_from_the_eye(int sphere, Color light)
{
    const Surface *surface = scene_surface(&world.scene, sphere);
    return ambient_of(sphere) + surface->diffuse * surface->color * light +
           surface->specular * light;
}

// Two mirrors that face each other: the first, the second in it, the first in that ...
static Color to_and_fro(Color first, double ks, Color second, double other_ks, int depth)
{
    Color sum = vec3_of(0, 0, 0);
    double share = 1;
    for (int i = 0; i <= depth; i++) {
        sum += share * (i % 2 == 0 ? first : second);
        share *= i % 2 == 0 ? ks : other_ks;
    }
    return sum;
}

// On the axis z, on both sides of the origin.
static void facing_mirrors(double ks, double other_ks)
{
    empty_world(&world);
    put_sphere(&world, vec3_of(0, 0, -5), 1, mirror(green, ks));
    put_sphere(&world, vec3_of(0, 0, 8), 2, mirror(pink, other_ks));
}

static const Ray ahead = {{0, 0, 0}, {0, 0, -2}}, behind = {{0, 0, 0}, {0, 0, 3}},
                 upward = {{0, 0, 0}, {0, 1, 0}};

START_TEST(where_nothing_is_hit_there_is_the_background)
{
    for (int depth = 0; depth < 3; depth++) {
        facing_mirrors(0.5, 0.25);
        put_light(&world, LIGHT_POINT, vec3_of(0, 9, 0), white);
        expect_trace(&world, upward, depth, world.scene.background);
        empty_world(&world);
        expect_trace(&world, upward, depth, world.scene.background);
    }
}
END_TEST

START_TEST(at_depth_0_a_mirror_shows_only_itself)
{
    facing_mirrors(0.5, 0.25);
    expect_trace(&world, ahead, 0, ambient_of(0));
    expect_trace(&world, behind, 0, ambient_of(1));
    put_light(&world, LIGHT_POINT, vec3_of(0, 0, 0), pink);
    expect_trace(&world, ahead, 0, lit_from_the_eye(0, pink));
}
END_TEST

START_TEST(a_surface_without_specular_is_no_mirror)
{
    facing_mirrors(0, 0.25);
    for (int depth = 0; depth < 4; depth++)
        expect_trace(&world, ahead, depth, ambient_of(0));
    expect_trace(&world, behind, 3, ambient_of(1) + 0.25 * ambient_of(0));
    put_light(&world, LIGHT_POINT, vec3_of(0, 0, 0), pink);
    expect_trace(&world, ahead, 3, lit_from_the_eye(0, pink));
}
END_TEST

START_TEST(a_mirror_shows_the_background_too)
{
    empty_world(&world);
    put_sphere(&world, vec3_of(0, 0, -5), 1, mirror(green, 0.5));
    for (int depth = 1; depth < 4; depth++)
        expect_trace(&world, ahead, depth, ambient_of(0) + 0.5 * world.scene.background);
}
END_TEST

START_TEST(one_mirror_shows_the_other)
{
    facing_mirrors(0.5, 0.25);
    expect_trace(&world, ahead, 1, ambient_of(0) + 0.5 * ambient_of(1));
    expect_trace(&world, behind, 1, ambient_of(1) + 0.25 * ambient_of(0));
}
END_TEST

START_TEST(mirrors_that_face_each_other_are_seen_as_often_as_depth_says)
{
    facing_mirrors(0.5, 0.25);
    for (int depth = 0; depth <= 6; depth++) {
        expect_trace(&world, ahead, depth,
                     to_and_fro(ambient_of(0), 0.5, ambient_of(1), 0.25, depth));
        expect_trace(&world, behind, depth,
                     to_and_fro(ambient_of(1), 0.25, ambient_of(0), 0.5, depth));
    }
}
END_TEST

START_TEST(a_perfect_mirror_takes_nothing_away)
{
    facing_mirrors(1, 1);
    expect_trace(&world, ahead, 20, 11 * ambient_of(0) + 10 * ambient_of(1));
}
END_TEST

START_TEST(what_a_mirror_shows_is_lit_as_it_is)
{
    facing_mirrors(0.5, 0.25);
    put_light(&world, LIGHT_POINT, vec3_of(0, 0, 0), pink);
    for (int depth = 1; depth <= 3; depth++)
        expect_trace(
            &world, ahead, depth,
            to_and_fro(lit_from_the_eye(0, pink), 0.5, lit_from_the_eye(1, pink), 0.25, depth));
}
END_TEST

// Bright light from the middle; the sum is not clamped on the way.
START_TEST(bright_light_is_not_clamped_in_mirrors_either)
{
    facing_mirrors(0.5, 0.25);
    put_light(&world, LIGHT_POINT, vec3_of(0, 0, 0), 8 * white);
    expect_trace(
        &world, ahead, 2,
        to_and_fro(lit_from_the_eye(0, 8 * white), 0.5, lit_from_the_eye(1, 8 * white), 0.25, 2));
}
END_TEST

// Hit at (3, 0, 4), where the normal is (3, 0, 4) / 5: what came along -z leaves along (24, 0, 7).
// Other spheres wait straight on, along the normal, the other way round, and back where it came
// from; and a lamp inside the ball, where nobody should see it.
START_TEST(the_angle_out_is_the_angle_in)
{
    const vec3 hit = {3, 0, 4}, mirrored = {0.96, 0, 0.28};
    empty_world(&world);
    put_sphere(&world, vec3_of(0, 0, 0), 5, mirror(green, 0.5));
    put_sphere(&world, hit + 10 * mirrored, 1, surface_of(pink, 0.7, 0, 1));
    put_sphere(&world, hit - 10 * mirrored, 1, surface_of(green, 0.9, 0, 1));
    put_sphere(&world, hit + 3 * hit, 1, surface_of(green, 0.8, 0, 1));
    put_sphere(&world, vec3_of(3, 0, -20), 1, surface_of(green, 0.6, 0, 1));
    put_sphere(&world, vec3_of(3, 0, 20), 1, surface_of(green, 0.4, 0, 1));
    put_light(&world, LIGHT_POINT, vec3_of(1, 2, 0), white);
    expect_trace(&world, (Ray){vec3_of(3, 0, 10), vec3_of(0, 0, -2)}, 1,
                 ambient_of(0) + 0.5 * ambient_of(1));
    expect_trace(&world, (Ray){vec3_of(3, 0, 10), vec3_of(0, 0, -2)}, 5,
                 ambient_of(0) + 0.5 * ambient_of(1));
}
END_TEST

START_TEST(how_long_the_direction_of_the_ray_is_does_not_matter)
{
    const double lengths[] = {0.01, 1, 7, 5000};
    facing_mirrors(0.5, 0.25);
    put_light(&world, LIGHT_POINT, vec3_of(0, 0, 0), pink);
    for (int i = 0; i < 4; i++)
        expect_trace(
            &world, (Ray){vec3_of(0, 0, 0), vec3_of(0, 0, -lengths[i])}, 2,
            to_and_fro(lit_from_the_eye(0, pink), 0.5, lit_from_the_eye(1, pink), 0.25, 2));
}
END_TEST

START_TEST(inside_a_hollow_mirror_a_ray_stays_inside)
{
    empty_world(&world);
    put_sphere(&world, vec3_of(0, 0, 0), 6, mirror(green, 0.5));
    put_sphere(&world, vec3_of(0, 0, 20), 6, mirror(pink, 0.5));
    put_light(&world, LIGHT_POINT, vec3_of(0, 0, 0), pink);
    for (int depth = 0; depth < 5; depth++)
        expect_trace(
            &world, (Ray){vec3_of(0, 0, 1), vec3_of(0, 0, 2)}, depth,
            to_and_fro(lit_from_the_eye(0, pink), 0.5, lit_from_the_eye(0, pink), 0.5, depth));
}
END_TEST

// A gap of 1e-5 of the radius between two spheres, along whose axis the eye looks from inside the
// gap.
START_TEST(mirrors_may_be_close_together_in_scenes_of_any_size)
{
    for (int i = 8; i >= -6; i -= 2) {
        double size = pow(10, i);
        empty_world(&world);
        put_sphere(&world, vec3_of(0, 0, -1.000005 * size), size, mirror(green, 0.5));
        put_sphere(&world, vec3_of(0, 0, 1.000005 * size), size, mirror(pink, 0.25));
        expect_trace(&world, (Ray){vec3_of(0, 0, 0), vec3_of(0, 0, -size)}, 4,
                     to_and_fro(ambient_of(0), 0.5, ambient_of(1), 0.25, 4));
    }
}
END_TEST

// Whatever a ball alone mirrors is not itself, also where the eye is close to it and the origin of
// the world is far away.
START_TEST(a_ball_does_not_see_itself)
{
    for (int i = 0; i < 40; i++) {
        double size = random_scale(1e6), away = pow(10, i % 2 == 0 ? 5 : random_number(0, 5));
        empty_world(&world);
        world.scene.background = random_color();
        vec3 center = size * away * random_unit();
        double ks = random_number(0.2, 0.9);
        put_sphere(&world, center, size, mirror(random_color(), ks));
        double distance = 1 + (i % 2 == 0 ? 1e-6 : random_number(0.1, 9));
        vec3 from = center + distance * size * random_unit();
        vec3 at = center + 0.6 * size * random_unit();
        expect_trace(&world, (Ray){from, at - from}, 1 + i % 3,
                     ambient_of(0) + ks * world.scene.background);
    }
}
END_TEST

START_TEST(on_any_axis_and_in_any_light_mirrors_face_each_other)
{
    for (int i = 0; i < 20; i++) {
        double size = random_scale(1e6), ks = random_number(0.2, 0.9);
        double other_ks = random_number(0.2, 0.9);
        vec3 eye = size * random_vec3(-5, 5), axis = random_unit();
        double radius = random_number(0.5, 3), other_radius = random_number(0.5, 3);
        double away = radius + random_number(1, 4), other_away = other_radius + random_number(1, 4);
        Color light = random_color();
        empty_world(&world);
        world.scene.ambient = random_color();
        world.scene.background = random_color();
        put_sphere(&world, eye + size * away * axis, size * radius, mirror(random_color(), ks));
        put_sphere(&world, eye - size * other_away * axis, size * other_radius,
                   mirror(random_color(), other_ks));
        put_light(&world, LIGHT_POINT, eye, light);
        int depth = i % 4;
        Ray ray = {eye, size * random_number(0.1, 9) * axis};
        expect_trace(&world, ray, depth,
                     to_and_fro(lit_from_the_eye(0, light), ks, lit_from_the_eye(1, light),
                                other_ks, depth));
    }
}
END_TEST

START_TEST(any_mirrors_show_what_geometry_says)
{
    for (int i = 0; i < 40;) {
        double size = random_scale(1e6);
        Color expected;
        random_world(&world, 6, 0, size);
        Ray ray = random_view(&world, size);
        int depth = i % 3;
        if (!exact_trace(&world, ray, depth, &expected))
            continue;
        expect_trace(&world, ray, depth, expected);
        i++;
    }
}
END_TEST

void list_tests_of_trace_ray(void)
{
    tests_of("trace_ray");
    test(where_nothing_is_hit_there_is_the_background);
    test(at_depth_0_a_mirror_shows_only_itself);
    test(a_surface_without_specular_is_no_mirror);
    test(a_mirror_shows_the_background_too);
    test(one_mirror_shows_the_other);
    test(mirrors_that_face_each_other_are_seen_as_often_as_depth_says);
    test(a_perfect_mirror_takes_nothing_away);
    test(what_a_mirror_shows_is_lit_as_it_is);
    test(bright_light_is_not_clamped_in_mirrors_either);
    test(the_angle_out_is_the_angle_in);
    test(how_long_the_direction_of_the_ray_is_does_not_matter);
    test(inside_a_hollow_mirror_a_ray_stays_inside);
    test(mirrors_may_be_close_together_in_scenes_of_any_size);
    test(a_ball_does_not_see_itself);
    test(on_any_axis_and_in_any_light_mirrors_face_each_other);
    test(any_mirrors_show_what_geometry_says);
}
