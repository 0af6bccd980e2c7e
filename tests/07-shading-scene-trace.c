// 07-shading-scene-trace.c - tests of trace_ray: mirrors, and how deep to look into them.
//
// Expected: mirrors on an axis, which send rays to and fro; a mirrored direction with sides 3, 4, 5
// and 7, 24, 25. More of them, random ones, are in 07-shading-scene-any.c.
#include "tests/07-shading-scene.h"

static const Color green = {0.2, 0.9, 0.3}, pink = {0.9, 0.4, 0.6}, white = {1, 1, 1};

static World world;

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
    expect_trace(&world, ahead, 0, ambient_of(&world, 0));
    expect_trace(&world, behind, 0, ambient_of(&world, 1));
    put_light(&world, LIGHT_POINT, vec3_of(0, 0, 0), pink);
    expect_trace(&world, ahead, 0, lit_from_the_eye(&world, 0, pink));
}
END_TEST

START_TEST(a_surface_without_specular_is_no_mirror)
{
    facing_mirrors(0, 0.25);
    for (int depth = 0; depth < 4; depth++)
        expect_trace(&world, ahead, depth, ambient_of(&world, 0));
    expect_trace(&world, behind, 3, ambient_of(&world, 1) + 0.25 * ambient_of(&world, 0));
    put_light(&world, LIGHT_POINT, vec3_of(0, 0, 0), pink);
    expect_trace(&world, ahead, 3, lit_from_the_eye(&world, 0, pink));
}
END_TEST

START_TEST(a_mirror_shows_the_background_too)
{
    empty_world(&world);
    put_sphere(&world, vec3_of(0, 0, -5), 1, mirror(green, 0.5));
    for (int depth = 1; depth < 4; depth++)
        expect_trace(&world, ahead, depth, ambient_of(&world, 0) + 0.5 * world.scene.background);
}
END_TEST

START_TEST(one_mirror_shows_the_other)
{
    facing_mirrors(0.5, 0.25);
    expect_trace(&world, ahead, 1, ambient_of(&world, 0) + 0.5 * ambient_of(&world, 1));
    expect_trace(&world, behind, 1, ambient_of(&world, 1) + 0.25 * ambient_of(&world, 0));
}
END_TEST

START_TEST(mirrors_that_face_each_other_are_seen_as_often_as_depth_says)
{
    facing_mirrors(0.5, 0.25);
    for (int depth = 0; depth <= 6; depth++) {
        expect_trace(&world, ahead, depth,
                     to_and_fro(ambient_of(&world, 0), 0.5, ambient_of(&world, 1), 0.25, depth));
        expect_trace(&world, behind, depth,
                     to_and_fro(ambient_of(&world, 1), 0.25, ambient_of(&world, 0), 0.5, depth));
    }
}
END_TEST

START_TEST(a_perfect_mirror_takes_nothing_away)
{
    facing_mirrors(1, 1);
    expect_trace(&world, ahead, 20, 11 * ambient_of(&world, 0) + 10 * ambient_of(&world, 1));
}
END_TEST

START_TEST(what_a_mirror_shows_is_lit_as_it_is)
{
    facing_mirrors(0.5, 0.25);
    put_light(&world, LIGHT_POINT, vec3_of(0, 0, 0), pink);
    for (int depth = 1; depth <= 3; depth++)
        expect_trace(&world, ahead, depth,
                     to_and_fro(lit_from_the_eye(&world, 0, pink), 0.5,
                                lit_from_the_eye(&world, 1, pink), 0.25, depth));
}
END_TEST

// Bright light from the middle; the sum is not clamped on the way.
START_TEST(bright_light_is_not_clamped_in_mirrors_either)
{
    facing_mirrors(0.5, 0.25);
    put_light(&world, LIGHT_POINT, vec3_of(0, 0, 0), 8 * white);
    expect_trace(&world, ahead, 2,
                 to_and_fro(lit_from_the_eye(&world, 0, 8 * white), 0.5,
                            lit_from_the_eye(&world, 1, 8 * white), 0.25, 2));
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
                 ambient_of(&world, 0) + 0.5 * ambient_of(&world, 1));
    expect_trace(&world, (Ray){vec3_of(3, 0, 10), vec3_of(0, 0, -2)}, 5,
                 ambient_of(&world, 0) + 0.5 * ambient_of(&world, 1));
}
END_TEST

START_TEST(how_long_the_direction_of_the_ray_is_does_not_matter)
{
    const double lengths[] = {0.01, 1, 7, 5000};
    facing_mirrors(0.5, 0.25);
    put_light(&world, LIGHT_POINT, vec3_of(0, 0, 0), pink);
    for (int i = 0; i < 4; i++)
        expect_trace(&world, (Ray){vec3_of(0, 0, 0), vec3_of(0, 0, -lengths[i])}, 2,
                     to_and_fro(lit_from_the_eye(&world, 0, pink), 0.5,
                                lit_from_the_eye(&world, 1, pink), 0.25, 2));
}
END_TEST

START_TEST(inside_a_hollow_mirror_a_ray_stays_inside)
{
    empty_world(&world);
    put_sphere(&world, vec3_of(0, 0, 0), 6, mirror(green, 0.5));
    put_sphere(&world, vec3_of(0, 0, 20), 6, mirror(pink, 0.5));
    put_light(&world, LIGHT_POINT, vec3_of(0, 0, 0), pink);
    for (int depth = 0; depth < 5; depth++)
        expect_trace(&world, (Ray){vec3_of(0, 0, 1), vec3_of(0, 0, 2)}, depth,
                     to_and_fro(lit_from_the_eye(&world, 0, pink), 0.5,
                                lit_from_the_eye(&world, 0, pink), 0.5, depth));
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
    list_more_tests_of_trace_ray();
    list_limits_of_trace_ray();
}
