// 07-shading-scene-scale.c - tests of shadows, shade and mirrors: no limit is right, of how many,
// how near, how far, how deep or how weak.
//
// Ladders: whoever has a limit fails at the rung behind it, and is known by that. Of many things
// there is room for all: the last that somebody has room for is there, and then one more.
#include "tests/07-shading-scene.h"

static World world;

static const vec3 origin = {0, 0, 0}, ahead = {0, 0, 1};
static const Color white = {1, 1, 1};

enum { RUNGS = 12 };

// 0.3, 0.03 ... 3e-12 and 30, 300 ... 3e12.
static double down(int i)
{
    return 3 * pow(10, -1 - i);
}

static double up(int i)
{
    return 3 * pow(10, 1 + i);
}

static Light light_at(LightKind kind, vec3 position)
{
    return (Light){.position = position, .color = white, .kind = kind};
}

// ---- visibility ---------------------------------------------------------------------------------

// One sphere whose near side is so far ahead, a tenth of that large.
static void one_sphere(double t)
{
    empty_world(&world);
    put_sphere(&world, 1.1 * t * ahead, 0.1 * t, dull());
}

START_TEST(however_near_it_hides_a_light)
{
    for (int i = 0; i < RUNGS; i++) {
        one_sphere(down(i));
        expect_visible(&world, origin, light_at(LIGHT_POINT, ahead), 0);
        expect_visible(&world, origin, light_at(LIGHT_DISTANT, ahead), 0);
    }
}
END_TEST

START_TEST(however_far_it_hides_a_light_that_is_beyond)
{
    for (int i = 0; i < RUNGS; i++) {
        one_sphere(up(i));
        expect_visible(&world, origin, light_at(LIGHT_DISTANT, ahead), 0);
        expect_visible(&world, origin, light_at(LIGHT_POINT, 2 * up(i) * ahead), 0);
        expect_visible(&world, origin, light_at(LIGHT_POINT, 0.9 * up(i) * ahead), 1);
    }
}
END_TEST

START_TEST(however_long_the_way_to_a_light_is_a_sphere_in_between_hides_it)
{
    for (int i = 0; i < RUNGS; i++) {
        one_sphere(1);
        expect_visible(&world, origin, light_at(LIGHT_DISTANT, down(i) * ahead), 0);
        expect_visible(&world, origin, light_at(LIGHT_DISTANT, up(i) * ahead), 0);
        expect_visible(&world, origin, light_at(LIGHT_POINT, up(i) * ahead), 0);
    }
}
END_TEST

// By a part of the radius that is ten times what a hit may be off: the surface is that close before
// the light, or behind it. The farther the light, the smaller is that beside the way to it.
START_TEST(what_is_just_before_a_light_hides_it_and_what_is_just_behind_does_not)
{
    for (int i = 0; i < 6; i++) {
        double away = i < 3 ? 10 : 900, gap = pow(10, -3 - i % 3);
        empty_world(&world);
        put_sphere(&world, (away + 1 - gap) * ahead, 1, dull());
        expect_visible(&world, origin, light_at(LIGHT_POINT, away * ahead), 0);
        empty_world(&world);
        put_sphere(&world, (away + 1 + gap) * ahead, 1, dull());
        expect_visible(&world, origin, light_at(LIGHT_POINT, away * ahead), 1);
    }
}
END_TEST

static const int rooms[] = {8, 10, 16, 20, 32, 50, 64, 100, 128, 256};
enum { ROOMS = sizeof rooms / sizeof *rooms };

START_TEST(the_last_of_however_many_spheres_hides_a_light)
{
    for (int i = 0; i <= 2 * ROOMS; i++) {
        int count = i < 2 * ROOMS ? rooms[i / 2] + i % 2 : MOST_SPHERES;
        empty_world(&world);
        for (int k = 1; k < count; k++)
            put_sphere(&world, vec3_of(2 + k, 3, 9), 1, dull());
        put_sphere(&world, 5 * ahead, 1, dull());
        expect_visible(&world, origin, light_at(LIGHT_POINT, 10 * ahead), 0);
    }
}
END_TEST

// ---- shade --------------------------------------------------------------------------------------

#define EYE_ABOVE ((Ray){vec3_of(0, 4, 0), vec3_of(0, -2, 0)})
#define HIT_AT_2 ((Hit){2, 0})

static Surface shiny(double kd, double ks, double shine)
{
    return surface_of(vec3_of(0.8, 0.6, 0.4), kd, ks, shine);
}

// The highest point of a sphere of radius 1 is the origin of the world.
static void world_seen_from_above(Surface surface)
{
    empty_world(&world);
    put_sphere(&world, vec3_of(0, -1, 0), 1, surface);
}

static Color ambient(void)
{
    return ambient_of(&world, 0);
}

// Straight above, where the light gives all that it can: of each light its number is its colour.
START_TEST(the_last_of_however_many_lights_counts)
{
    static const int most[] = {2, 3, 4, 5, 8, 10, 16, 20, 32};
    for (int i = 0; i < 18; i++) {
        int count = most[i / 2] + i % 2;
        Color sum = vec3_of(0, 0, 0);
        world_seen_from_above(shiny(0.5, 0.4, 3));
        for (int k = 0; k < count; k++) {
            Color color = (k == count - 1 ? 0.5 : 0.01) * vec3_of(0.9, 0.7, 0.5);
            sum += color;
            put_light(&world, k % 2 == 0 ? LIGHT_POINT : LIGHT_DISTANT, vec3_of(0, 9 + k, 0),
                      color);
        }
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient() + 0.5 * vec3_of(0.8, 0.6, 0.4) * sum + 0.4 * sum);
    }
}
END_TEST

START_TEST(light_of_any_strength_is_scattered_and_mirrored)
{
    for (int i = 0; i < 2 * RUNGS; i++) {
        double strength = i < RUNGS ? down(i) : up(i - RUNGS);
        Color color = strength * vec3_of(0.9, 0.7, 0.5);
        world_seen_from_above(shiny(0.5, 0.4, 3));
        world.scene.ambient *= strength;
        world.scene.background *= strength;
        put_light(&world, LIGHT_POINT, vec3_of(0, 9, 0), color);
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient() + 0.5 * vec3_of(0.8, 0.6, 0.4) * color + 0.4 * color);
    }
}
END_TEST

// 0.3, 0.03 ... 3e-7, above the horizon of a light that is white.
enum { SMALL = 7 };

START_TEST(however_low_the_light_is_it_is_scattered)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = down(i) / hypot(1, down(i));
        world_seen_from_above(shiny(0.5, 0, 3));
        put_light(&world, LIGHT_DISTANT, vec3_of(1, down(i), 0), white);
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient() + 0.5 * cosine * vec3_of(0.8, 0.6, 0.4));
    }
}
END_TEST

START_TEST(however_little_a_surface_sends_back_it_counts)
{
    for (int i = 0; i < SMALL; i++) {
        world_seen_from_above(shiny(0.5, down(i), 3));
        put_light(&world, LIGHT_DISTANT, vec3_of(0, 1, 0), white);
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient() + 0.5 * vec3_of(0.8, 0.6, 0.4) + down(i) * white);
        world_seen_from_above(shiny(down(i), 0.4, 3));
        put_light(&world, LIGHT_DISTANT, vec3_of(0, 1, 0), white);
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient() + down(i) * vec3_of(0.8, 0.6, 0.4) + 0.4 * white);
    }
}
END_TEST

// From straight above the highlight is all of ks, whatever its power; at 60 degrees 2^-shine of it.
START_TEST(a_surface_has_the_shine_that_it_says)
{
    const double shines[] = {0, 0.5, 1, 2, 10, 20};
    for (int i = 0; i < 6; i++) {
        world_seen_from_above(shiny(0.5, 0.4, shines[i]));
        put_light(&world, LIGHT_DISTANT, vec3_of(0.86602540378443864676, 0.5, 0), white);
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient() + 0.25 * vec3_of(0.8, 0.6, 0.4) + 0.4 * pow(2, -shines[i]) * white);
    }
}
END_TEST

START_TEST(at_any_t_a_surface_is_lit)
{
    for (int i = 0; i < 2 * RUNGS; i++) {
        double t = i < RUNGS ? down(i) : up(i - RUNGS);
        world_seen_from_above(shiny(0.5, 0.4, 3));
        put_light(&world, LIGHT_POINT, vec3_of(0, 9, 0), white);
        expect_shade(&world, (Ray){vec3_of(0, 4, 0), vec3_of(0, -4 / t, 0)}, (Hit){t, 0},
                     ambient() + 0.5 * vec3_of(0.8, 0.6, 0.4) + 0.4 * white);
    }
}
END_TEST

// ---- trace_ray ----------------------------------------------------------------------------------

// Two mirrors on the axis, 4 before the eye and 6 behind it.
static void facing(double ks, double other_ks)
{
    empty_world(&world);
    put_sphere(&world, vec3_of(0, 0, 5), 1, mirror(vec3_of(0.2, 0.9, 0.3), ks));
    put_sphere(&world, vec3_of(0, 0, -8), 2, mirror(vec3_of(0.9, 0.4, 0.6), other_ks));
}

START_TEST(mirrors_are_looked_into_as_deep_as_it_says)
{
    static const int depths[] = {2, 3, 4, 5, 6, 8, 10, 15, 16, 20, 30, 32, 50, 64, 99, 100, 128};
    for (int i = 0; i < 34; i++) {
        int depth = depths[i / 2] + i % 2;
        facing(1, 1);
        expect_trace(&world, (Ray){origin, 2 * ahead}, depth,
                     to_and_fro(ambient_of(&world, 0), 1, ambient_of(&world, 1), 1, depth));
    }
}
END_TEST

START_TEST(however_weak_a_mirror_is_it_mirrors)
{
    for (int i = 0; i < SMALL; i++) {
        empty_world(&world);
        world.scene.background = white;
        put_sphere(&world, vec3_of(0, 0, 5), 1, mirror(vec3_of(0.2, 0.9, 0.3), down(i)));
        expect_trace(&world, (Ray){origin, 2 * ahead}, 3, ambient_of(&world, 0) + down(i) * white);
    }
}
END_TEST

// In each other they show less and less: 0.04, 0.0016 ... 3e-7 of it.
START_TEST(however_little_comes_through_all_mirrors_it_counts)
{
    for (int depth = 0; depth <= 5; depth++) {
        facing(0.04, 0.04);
        world.scene.ambient = 3 * white;
        expect_trace(&world, (Ray){origin, 2 * ahead}, depth,
                     to_and_fro(ambient_of(&world, 0), 0.04, ambient_of(&world, 1), 0.04, depth));
    }
}
END_TEST

START_TEST(at_any_t_there_is_a_mirror)
{
    for (int i = 0; i < 2 * RUNGS; i++) {
        facing(0.5, 0.25);
        expect_trace(&world, (Ray){origin, (i < RUNGS ? down(i) : up(i - RUNGS)) * ahead}, 2,
                     to_and_fro(ambient_of(&world, 0), 0.5, ambient_of(&world, 1), 0.25, 2));
    }
}
END_TEST

START_TEST(the_last_of_however_many_spheres_is_mirrored)
{
    for (int i = 0; i <= 2 * ROOMS; i++) {
        int count = i < 2 * ROOMS ? rooms[i / 2] + i % 2 : MOST_SPHERES;
        facing(0.5, 0);
        world.scene.sphere_count = 1;
        for (int k = 2; k < count; k++)
            put_sphere(&world, vec3_of(2 + k, 3, 0), 1, dull());
        put_sphere(&world, vec3_of(0, 0, -8), 2, dull());
        expect_trace(&world, (Ray){origin, 2 * ahead}, 1,
                     ambient_of(&world, 0) + 0.5 * ambient_of(&world, count - 1));
    }
}
END_TEST

void list_limits_of_visibility(void)
{
    test(however_near_it_hides_a_light);
    test(however_far_it_hides_a_light_that_is_beyond);
    test(however_long_the_way_to_a_light_is_a_sphere_in_between_hides_it);
    test(what_is_just_before_a_light_hides_it_and_what_is_just_behind_does_not);
    test(the_last_of_however_many_spheres_hides_a_light);
}

void list_limits_of_shade(void)
{
    test(the_last_of_however_many_lights_counts);
    test(light_of_any_strength_is_scattered_and_mirrored);
    test(however_low_the_light_is_it_is_scattered);
    test(however_little_a_surface_sends_back_it_counts);
    test(a_surface_has_the_shine_that_it_says);
    test(at_any_t_a_surface_is_lit);
}

void list_limits_of_trace_ray(void)
{
    test(mirrors_are_looked_into_as_deep_as_it_says);
    test(however_weak_a_mirror_is_it_mirrors);
    test(however_little_comes_through_all_mirrors_it_counts);
    test(at_any_t_there_is_a_mirror);
    test(the_last_of_however_many_spheres_is_mirrored);
}
