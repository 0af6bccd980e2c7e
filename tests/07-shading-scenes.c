// 07-shading-scenes.c - tests of exercise 07 that need a scene: leaving a surface, shadows, shade,
// mirrors.
#include "tests/07-shading/support-scene.h"

#include <stdio.h>

#define EYE_ABOVE ((Ray){vec3_of(0, 4, 0), vec3_of(0, -2, 0)})
#define HIT_AT_2 ((Hit){2, 0})

// ---- off_surface: how far, and to which side ---------------------------------------------------

// From a point of the sphere, straight to the side of the normal, by the step that the contract
// allows: any number from 2^-32 to 2^-28 of the size.
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
    snprintf(expected, sizeof expected,
             "moved by %.24s to %.24s along the normal, and not to the side",
             number_text_to(0x1p-32 * size, 3).s, number_text_to(0x1p-28 * size, 3).s);
    expect_law(along >= 0x1p-32 * size - rounding && along <= 0x1p-28 * size + rounding &&
                   aside <= rounding,
               expected, "moved by %.40s along the normal, by %.40s to the side",
               number_text_to(along, 3).s, number_text_to(aside, 3).s);
}

static Sphere sphere_round(vec3 center, double radius)
{
    return (Sphere){.center = center, .radius = radius};
}

// So that the sphere touches the origin of the world, where the smallest step is visible.
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

// The farther from the origin of the world, the coarser the numbers are.
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

START_TEST(around_the_origin_of_the_world_the_radius_counts)
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

// ---- visibility: spheres between a point and a light ------------------------------------------

// By hand, mostly on an axis.

// One or more spheres on the z axis, given by centre and radius; seen from the origin.
static World on_the_axis;

static const World *spheres_on_the_axis(int count, const double centers[], const double radii[])
{
    empty_world(&on_the_axis);
    for (int i = 0; i < count; i++)
        put_sphere(&on_the_axis, vec3_of(0, 0, centers[i]), radii[i], dull());
    return &on_the_axis;
}

static const World *sphere_on_the_axis(double center, double radius)
{
    return spheres_on_the_axis(1, &center, &radius);
}

static const vec3 origin = {0, 0, 0};

START_TEST(in_an_empty_scene_light_arrives)
{
    const World *nothing = spheres_on_the_axis(0, NULL, NULL);
    expect_visible(nothing, origin, point_light(1, 2, 3), 1);
    expect_visible(nothing, origin, distant_light(1, 2, 3), 1);
}
END_TEST

START_TEST(a_sphere_in_between_hides_a_light)
{
    expect_visible(sphere_on_the_axis(5, 1), origin, point_light(0, 0, 10), 0);
    expect_visible(sphere_on_the_axis(5, 1), origin, distant_light(0, 0, 10), 0);
    expect_visible(sphere_on_the_axis(-5, 1), vec3_of(0, 0.5, -9), point_light(0, 0.5, 0), 0);
}
END_TEST

START_TEST(a_sphere_beside_the_way_hides_nothing)
{
    expect_visible(sphere_on_the_axis(5, 1), vec3_of(1.5, 0, 0), point_light(1.5, 0, 10), 1);
    expect_visible(sphere_on_the_axis(5, 1), vec3_of(1.5, 0, 0), distant_light(0, 0, 10), 1);
    // The direction counts, not where its tip is.
    expect_visible(sphere_on_the_axis(5, 1), vec3_of(0, 4, 0), distant_light(0, 0, 5), 1);
}
END_TEST

// Seen from (0, 6, 0) the light is beyond the sphere; the vector to its coordinates has another
// direction.
START_TEST(the_way_to_a_point_light_starts_at_the_point)
{
    expect_visible(sphere_on_the_axis(4, 1), vec3_of(0, 6, 0), point_light(0, -6, 8), 0);
    expect_visible(sphere_on_the_axis(4, 1), vec3_of(0, 6, 0), point_light(0, 0, 8), 1);
}
END_TEST

// By chance these are 1 in lengths of the vector to the light; that of (0, 0, 4) is 4 long.
START_TEST(a_sphere_behind_a_point_light_hides_nothing)
{
    expect_visible(sphere_on_the_axis(6, 1), origin, point_light(0, 0, 4), 1);
    expect_visible(sphere_on_the_axis(0.5, 0.1), origin, point_light(0, 0, 0.25), 1);
    expect_visible(sphere_on_the_axis(5.5, 1), origin, point_light(0, 0, 4), 1);
}
END_TEST

START_TEST(a_sphere_far_from_the_point_but_in_front_of_the_light_hides_it)
{
    expect_visible(sphere_on_the_axis(9e5, 1e4), origin, point_light(0, 0, 1e6), 0);
    expect_visible(sphere_on_the_axis(9e-5, 1e-6), origin, point_light(0, 0, 1e-4), 0);
}
END_TEST

START_TEST(a_sphere_behind_the_point_hides_nothing)
{
    expect_visible(sphere_on_the_axis(-5, 1), origin, point_light(0, 0, 4), 1);
    expect_visible(sphere_on_the_axis(-5, 1), origin, distant_light(0, 0, 4), 1);
    expect_visible(sphere_on_the_axis(-1.5, 1), origin, point_light(0, 0, 4), 1);
}
END_TEST

START_TEST(a_distant_light_is_beyond_everything)
{
    expect_visible(sphere_on_the_axis(5, 1), origin, distant_light(0, 0, 1), 0);
    expect_visible(sphere_on_the_axis(1e6, 10), origin, distant_light(0, 0, 0.01), 0);
}
END_TEST

START_TEST(how_long_the_direction_of_a_distant_light_is_does_not_matter)
{
    const double lengths[] = {1e-6, 0.1, 1, 30, 1e6};
    for (int i = 0; i < 5; i++) {
        expect_visible(sphere_on_the_axis(5, 1), origin, distant_light(0, 0, lengths[i]), 0);
        expect_visible(sphere_on_the_axis(-5, 1), origin, distant_light(0, 0, lengths[i]), 1);
    }
}
END_TEST

static void expect_hidden_by_one_of_four(int which)
{
    World world;
    empty_world(&world);
    for (int i = 0; i < 4; i++)
        put_sphere(&world, i == which ? vec3_of(0, 0, 5) : vec3_of(3 + i, 0, 5), 1, dull());
    expect_visible(&world, origin, point_light(0, 0, 10), 0);
    expect_visible(&world, origin, distant_light(0, 0, 10), 0);
    expect_visible(&world, vec3_of(0, 5, 0), point_light(0, 5, 10), 1);
}

START_TEST(the_first_of_many_spheres_is_enough)
{
    expect_hidden_by_one_of_four(0);
}
END_TEST

START_TEST(the_last_of_many_spheres_is_enough)
{
    expect_hidden_by_one_of_four(3);
}
END_TEST

START_TEST(one_among_many_spheres_is_enough)
{
    expect_hidden_by_one_of_four(1);
    expect_hidden_by_one_of_four(2);
}
END_TEST

START_TEST(two_spheres_hide_a_light_no_more_than_one)
{
    const World *world =
        spheres_on_the_axis(3, (const double[]){3, 5, 8}, (const double[]){1, 0.5, 1});
    expect_visible(world, origin, point_light(0, 0, 10), 0);
    expect_visible(world, origin, distant_light(0, 0, 10), 0);
}
END_TEST

// The nearest of all does not hide it: it is behind the light, beside the way or behind the point.
START_TEST(of_spheres_only_those_in_between_count)
{
    const World *world =
        spheres_on_the_axis(3, (const double[]){-2, 5, 14}, (const double[]){1, 1, 1});
    expect_visible(world, origin, point_light(0, 0, 10), 0);
    expect_visible(world, origin, point_light(0, 0, 3), 1);
    expect_visible(world, vec3_of(0, 0, 8), point_light(0, 0, 12), 1);
}
END_TEST

START_TEST(from_inside_a_sphere_only_lights_inside_it_are_seen)
{
    expect_visible(sphere_on_the_axis(0, 5), vec3_of(0, 0, 1), point_light(0, 0, 10), 0);
    expect_visible(sphere_on_the_axis(0, 5), vec3_of(0, 0, 1), point_light(0, 0, 4), 1);
    expect_visible(sphere_on_the_axis(0, 5), vec3_of(0, 0, 1), point_light(3, 0, -3), 1);
    expect_visible(sphere_on_the_axis(0, 5), vec3_of(0, 0, 1), distant_light(0, 0, 0.1), 0);
}
END_TEST

START_TEST(a_light_inside_a_sphere_is_not_seen_from_outside)
{
    expect_visible(sphere_on_the_axis(9, 2), origin, point_light(0, 0, 9), 0);
    expect_visible(sphere_on_the_axis(9, 2), origin, point_light(0, 1, 8), 0);
}
END_TEST

START_TEST(a_sphere_close_to_the_point_also_hides_a_light)
{
    const double gaps[] = {3e-2, 3e-3, 3e-4, 3e-5, 3e-6, 3e-7, 3e-8};
    for (int i = 0; i < 7; i++) {
        const World *world = sphere_on_the_axis(1 + gaps[i], 1);
        expect_visible(world, origin, point_light(0, 0, 100), 0);
        expect_visible(world, origin, distant_light(0, 0, 1), 0);
        expect_visible(world, origin, distant_light(0, 0, 100), 0);
    }
}
END_TEST

START_TEST(a_sphere_close_to_a_light_also_hides_it)
{
    const double gaps[] = {1e-2, 1e-4, 1e-6};
    for (int i = 0; i < 3; i++) {
        double radius = gaps[i] / 4;
        expect_visible(sphere_on_the_axis(1 - gaps[i], radius), origin, point_light(0, 0, 1), 0);
        expect_visible(sphere_on_the_axis(1 + gaps[i], radius), origin, point_light(0, 0, 1), 1);
    }
}
END_TEST

START_TEST(glass_hides_a_light_like_anything_else)
{
    World world;
    Surface glass = surface_of(vec3_of(0.9, 0.9, 0.9), 0.1, 0.3, 9);
    glass.transmittance = 0.8;
    empty_world(&world);
    put_sphere(&world, vec3_of(0, 0, 5), 1, glass);
    given("known", "the sphere lets 0.8 of the light through");
    expect_visible(&world, origin, point_light(0, 0, 10), 0);
}
END_TEST

// ---- shade: the terms of each light, by hand ---------------------------------------------------

// A sphere of radius 1 whose highest point is the origin of the world, seen from straight above:
// there the normal is up, and so is the direction to the eye. Ambient is 0.5 * (0.8, 0.6, 0.4)
// times the ambient light.
static const Color ambient = {0.5 * 0.8 * 0.3, 0.5 * 0.6 * 0.2, 0.5 * 0.4 * 0.1};

static World world;

static void world_seen_from_above(double specular, double shine)
{
    empty_world(&world);
    put_sphere(&world, vec3_of(0, -1, 0), 1, surface_of(dull().color, 0.5, specular, shine));
}

// The light at 60 degrees, 10 away: the cosine is 1/2, on both sides of the normal.
static const vec3 at_60_degrees = {8.6602540378443864676, 5, 0};
static const Color yellow = {0.9, 0.7, 0.1}, blue = {0.1, 0.2, 0.8}, red = {0.7, 0.2, 0.3};

static Color diffuse(double cosine, Color light)
{
    return 0.5 * cosine * vec3_of(0.8, 0.6, 0.4) * light;
}

START_TEST(without_lights_only_ambient_light_is_left)
{
    world_seen_from_above(0.4, 3);
    expect_shade(&world, EYE_ABOVE, HIT_AT_2, ambient);
    world.scene.ambient = vec3_of(1, 0.5, 0);
    expect_shade(&world, EYE_ABOVE, HIT_AT_2, vec3_of(0.4, 0.15, 0));
}
END_TEST

START_TEST(a_light_straight_above_has_its_full_effect)
{
    for (int kind = LIGHT_POINT; kind <= LIGHT_DISTANT; kind++) {
        world_seen_from_above(0.4, 3);
        put_light(&world, (LightKind)kind, vec3_of(0, 9, 0), yellow);
        expect_shade(&world, EYE_ABOVE, HIT_AT_2, ambient + diffuse(1, yellow) + 0.4 * yellow);
    }
}
END_TEST

START_TEST(a_dull_surface_has_no_highlight)
{
    world_seen_from_above(0, 3);
    put_light(&world, LIGHT_POINT, vec3_of(0, 9, 0), yellow);
    expect_shade(&world, EYE_ABOVE, HIT_AT_2, ambient + diffuse(1, yellow));
}
END_TEST

// 1/2 for diffuse, (1/2)^3 for the highlight, which has the colour of the light.
START_TEST(a_light_at_an_angle_has_less_of_both_terms)
{
    for (int kind = LIGHT_POINT; kind <= LIGHT_DISTANT; kind++) {
        world_seen_from_above(0.4, 3);
        put_light(&world, (LightKind)kind, at_60_degrees, yellow);
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient + diffuse(0.5, yellow) + 0.4 / 8 * yellow);
    }
}
END_TEST

// Light and eye at 60 degrees to the normal each, on opposite sides: the mirrored light meets it.
START_TEST(the_highlight_is_where_the_mirrored_light_meets_the_eye)
{
    world_seen_from_above(0.4, 3);
    put_light(&world, LIGHT_POINT, at_60_degrees, yellow);
    vec3 eye = vec3_of(-at_60_degrees[0], at_60_degrees[1], 0);
    expect_shade(&world, (Ray){eye, -eye / 2}, HIT_AT_2,
                 ambient + diffuse(0.5, yellow) + 0.4 * yellow);
}
END_TEST

START_TEST(if_the_mirrored_light_goes_away_from_the_eye_there_is_no_highlight)
{
    world_seen_from_above(0.4, 3);
    put_light(&world, LIGHT_POINT, at_60_degrees, yellow);
    vec3 eye = at_60_degrees / 2;
    expect_shade(&world, (Ray){eye, -eye / 2}, HIT_AT_2, ambient + diffuse(0.5, yellow));
}
END_TEST

START_TEST(lights_add_up)
{
    world_seen_from_above(0.4, 3);
    put_light(&world, LIGHT_POINT, at_60_degrees, yellow);
    put_light(&world, LIGHT_DISTANT, vec3_of(0, 2, 0), blue);
    put_light(&world, LIGHT_POINT, vec3_of(0, 3, 0), red);
    expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                 ambient + diffuse(0.5, yellow) + 0.4 / 8 * yellow + diffuse(1, blue) + 0.4 * blue +
                     diffuse(1, red) + 0.4 * red);
}
END_TEST

START_TEST(in_the_shadow_the_ambient_light_is_left)
{
    for (int kind = LIGHT_POINT; kind <= LIGHT_DISTANT; kind++) {
        world_seen_from_above(0.4, 3);
        put_light(&world, (LightKind)kind, at_60_degrees, yellow);
        put_sphere(&world, at_60_degrees / 2, 1, dull());
        expect_shade(&world, EYE_ABOVE, HIT_AT_2, ambient);
    }
}
END_TEST

START_TEST(a_light_that_is_hidden_takes_nothing_from_the_others)
{
    for (int hidden = 0; hidden < 3; hidden++) {
        world_seen_from_above(0.4, 3);
        for (int i = 0; i < 3; i++)
            put_light(&world, LIGHT_POINT,
                      i == hidden ? vec3_of(-at_60_degrees[0], at_60_degrees[1], 0) : at_60_degrees,
                      i == 0   ? yellow
                      : i == 1 ? blue
                               : red);
        put_sphere(&world, vec3_of(-at_60_degrees[0], at_60_degrees[1], 0) / 2, 1, dull());
        Color all = yellow + blue + red;
        Color others = all - world.lights[hidden].color;
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient + diffuse(0.5, others) + 0.4 / 8 * others);
    }
}
END_TEST

START_TEST(a_sphere_behind_a_light_or_beside_it_makes_no_shadow)
{
    world_seen_from_above(0.4, 3);
    put_light(&world, LIGHT_POINT, at_60_degrees, yellow);
    put_sphere(&world, 1.5 * at_60_degrees, 1, dull());
    put_sphere(&world, vec3_of(-3, 3, 0), 1, dull());
    expect_shade(&world, EYE_ABOVE, HIT_AT_2, ambient + diffuse(0.5, yellow) + 0.4 / 8 * yellow);
}
END_TEST

START_TEST(a_surface_that_is_turned_away_from_the_light_is_in_its_own_shadow)
{
    world_seen_from_above(0.4, 3);
    put_light(&world, LIGHT_POINT, vec3_of(0, -9, 0), yellow);
    put_light(&world, LIGHT_DISTANT, vec3_of(3, -1, 0), blue);
    expect_shade(&world, EYE_ABOVE, HIT_AT_2, ambient);
}
END_TEST

START_TEST(bright_light_is_not_clamped)
{
    world_seen_from_above(0.4, 3);
    put_light(&world, LIGHT_POINT, vec3_of(0, 9, 0), 10 * yellow);
    expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                 ambient + diffuse(1, 10 * yellow) + 0.4 * 10 * yellow);
}
END_TEST

// The other sphere is hit 1 to the left of the first; its own surface is plainer.
START_TEST(the_surface_is_that_of_the_sphere_that_was_hit)
{
    world_seen_from_above(0.4, 3);
    put_sphere(&world, vec3_of(-5, -2, 0), 2, surface_of(vec3_of(0.3, 0.9, 0.5), 0.25, 0.75, 1));
    put_light(&world, LIGHT_DISTANT, vec3_of(0, 1, 0), yellow);
    expect_shade(&world, (Ray){vec3_of(-5, 4, 0), vec3_of(0, -2, 0)}, (Hit){2, 1},
                 0.25 * vec3_of(0.3, 0.9, 0.5) * (world.scene.ambient + yellow) + 0.75 * yellow);
}
END_TEST

START_TEST(how_long_the_direction_of_the_ray_is_does_not_change_the_shade)
{
    const double lengths[] = {0.01, 1, 8, 4000};
    world_seen_from_above(0.4, 3);
    put_light(&world, LIGHT_POINT, at_60_degrees, yellow);
    for (int i = 0; i < 4; i++)
        expect_shade(&world, (Ray){vec3_of(0, 4, 0), vec3_of(0, -lengths[i], 0)},
                     (Hit){4 / lengths[i], 0}, ambient + diffuse(0.5, yellow) + 0.4 / 8 * yellow);
}
END_TEST

// Eye and light in a hollow sphere around the origin, opposite the point: its surface faces them.
START_TEST(inside_a_sphere_the_normal_points_to_the_eye)
{
    empty_world(&world);
    put_sphere(&world, vec3_of(0, 0, 0), 6, surface_of(dull().color, 0.5, 0.4, 3));
    put_light(&world, LIGHT_POINT, vec3_of(0, -2, 0), yellow);
    put_light(&world, LIGHT_POINT, vec3_of(0, 9, 0), blue);
    put_light(&world, LIGHT_DISTANT, vec3_of(0, -1, 0), red);
    put_light(&world, LIGHT_DISTANT, vec3_of(0, 1, 0), red);
    expect_shade(&world, (Ray){vec3_of(0, 2, 0), vec3_of(0, 2, 0)}, HIT_AT_2,
                 ambient + diffuse(1, yellow) + 0.4 * yellow);
    expect_shade(&world, (Ray){vec3_of(0, 5, 0), vec3_of(0, 0.5, 0)}, HIT_AT_2,
                 ambient + diffuse(1, yellow) + 0.4 * yellow);
}
END_TEST

// ---- trace_ray: mirrors, and how deep to look into them ----------------------------------------

// Mirrors on an axis, which send rays to and fro; a mirrored direction with sides 3, 4, 5 and 7,
// 24, 25.

static const Color green = {0.2, 0.9, 0.3}, pink = {0.9, 0.4, 0.6}, white = {1, 1, 1};

// On the axis z, on both sides of the origin.
static void facing_mirrors(double ks, double other_ks)
{
    empty_world(&world);
    put_sphere(&world, vec3_of(0, 0, -5), 1, mirror(green, ks));
    put_sphere(&world, vec3_of(0, 0, 8), 2, mirror(pink, other_ks));
}

static const Ray ahead = {{0, 0, 0}, {0, 0, -2}}, behind = {{0, 0, 0}, {0, 0, 3}},
                 upward = {{0, 0, 0}, {0, 1, 0}};

START_TEST(if_nothing_is_hit_the_background_is_seen)
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

START_TEST(a_surface_without_specular_is_not_a_mirror)
{
    facing_mirrors(0, 0.25);
    for (int depth = 0; depth < 4; depth++)
        expect_trace(&world, ahead, depth, ambient_of(&world, 0));
    expect_trace(&world, behind, 3, ambient_of(&world, 1) + 0.25 * ambient_of(&world, 0));
    put_light(&world, LIGHT_POINT, vec3_of(0, 0, 0), pink);
    expect_trace(&world, ahead, 3, lit_from_the_eye(&world, 0, pink));
}
END_TEST

START_TEST(a_mirror_also_shows_the_background)
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

START_TEST(a_perfect_mirror_loses_no_light)
{
    facing_mirrors(1, 1);
    expect_trace(&world, ahead, 20, 11 * ambient_of(&world, 0) + 10 * ambient_of(&world, 1));
}
END_TEST

START_TEST(objects_in_a_mirror_are_lit_as_usual)
{
    facing_mirrors(0.5, 0.25);
    put_light(&world, LIGHT_POINT, vec3_of(0, 0, 0), pink);
    for (int depth = 1; depth <= 3; depth++)
        expect_trace(&world, ahead, depth,
                     to_and_fro(lit_from_the_eye(&world, 0, pink), 0.5,
                                lit_from_the_eye(&world, 1, pink), 0.25, depth));
}
END_TEST

// Bright light from the centre; the sum is not clamped on the way.
START_TEST(bright_light_is_not_clamped_in_mirrors_either)
{
    facing_mirrors(0.5, 0.25);
    put_light(&world, LIGHT_POINT, vec3_of(0, 0, 0), 8 * white);
    expect_trace(&world, ahead, 2,
                 to_and_fro(lit_from_the_eye(&world, 0, 8 * white), 0.5,
                            lit_from_the_eye(&world, 1, 8 * white), 0.25, 2));
}
END_TEST

// Hit at (3, 0, 4), where the normal is (3, 0, 4) / 5: a ray along -z leaves along (24, 0, 7).
// Other spheres are straight on, along the normal, in the opposite direction, and back at the
// start; and a lamp is inside the ball, where no ray should see it.
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
    for (int i = 0; i < 10; i++)
        expect_trace(&world, (Ray){vec3_of(0, 0, 1), vec3_of(0, 0, i < 5 ? 2 : 0.03)}, i % 5,
                     to_and_fro(lit_from_the_eye(&world, 0, pink), 0.5,
                                lit_from_the_eye(&world, 0, pink), 0.5, i % 5));
}
END_TEST

// ---- scenes of any size, and random ones -------------------------------------------------------

// The colour in a mirror must not depend on how far a right answer goes off its surface: random
// mirrors face each other on an axis, or their colours are ambient only.

// ---- visibility ---------------------------------------------------------------------------------

// The shadow of a sphere in the light of a point is a cone: its half angle has the sine radius /
// distance. Points behind the sphere, a little inside that cone and a little outside.
START_TEST(in_an_eclipse_the_shadow_is_a_cone)
{
    for (int i = 0; i < 20; i++) {
        empty_world(&world);
        double scale = random_size(1e6), moon = random_number(0.2, 2), away = random_number(3, 9);
        vec3 sun = random_vec3(-5, 5), axis = random_unit();
        vec3 aside = vec3_unit(vec3_cross(axis, random_unit()));
        double sine = moon / away, tangent = sine / sqrt(1 - sine * sine);
        double beyond = away + random_number(2.1, 9);
        put_sphere(&world, (sun + away * axis) * scale, moon * scale, dull());
        Light light = {.position = sun * scale, .color = {1, 1, 1}, .kind = LIGHT_POINT};
        for (int k = 0; k < 2; k++) {
            double within = k == 0 ? random_number(0, 0.99) : random_number(1.01, 1.3);
            vec3 place = sun + beyond * axis + within * beyond * tangent * aside;
            expect_visible(&world, place * scale, light, k);
        }
    }
}
END_TEST

START_TEST(any_spheres_hide_any_light_as_geometry_says)
{
    double visible;
    for (int i = 0, seen = 0, hidden = 0; i < 40 || seen < 8 || hidden < 8;) {
        double size = random_size(1e6);
        random_world(&world, 5, 1, size);
        vec3 from = random_vec3(-6, 6) * size;
        if (!exact_visibility(&world, from, world.lights[0], &visible))
            continue;
        expect_visible(&world, from, world.lights[0], visible);
        i++;
        *(visible > 0 ? &seen : &hidden) += 1;
    }
}
END_TEST

// ---- shade --------------------------------------------------------------------------------------

// A hit is right only to within rounding. So these are in front of the surface or behind it by
// 5e-11 of the radius, less than the smallest step of off_surface.
START_TEST(a_hit_that_rounding_put_just_inside_the_sphere_is_lit)
{
    for (int i = -6; i <= 8; i += 2) {
        double size = pow(10, i);
        for (int side = -1; side <= 1; side++) {
            empty_world(&world);
            put_sphere(&world, vec3_of(0, -size, 0), size, surface_of(dull().color, 0.5, 0.4, 3));
            put_light(&world, LIGHT_POINT, size * at_60_degrees, yellow);
            Ray ray = {vec3_of(0, 4 * size, 0), vec3_of(0, -size, 0)};
            expect_shade(&world, ray, (Hit){4 + side * 5e-11, 0},
                         ambient_of(&world, 0) + diffuse(0.5, yellow) + 0.4 / 8 * yellow);
            ray.origin = vec3_of(0, 0.001 * size, 0); // the eye is close, and t counts from there
            expect_shade(&world, ray, (Hit){0.001 + side * 5e-11, 0},
                         ambient_of(&world, 0) + diffuse(0.5, yellow) + 0.4 / 8 * yellow);
        }
    }
}
END_TEST

// The crumb is this many radii above it, and half as large: in the way of the light from above,
// beside the way of the other, whose mirror image meets the eye.
START_TEST(a_tiny_sphere_close_to_the_surface_casts_its_shadow)
{
    for (int i = 0; i < 30; i++) {
        double size = pow(10, 8 - i % 15), above = i < 15 ? 1e-5 : 1e-7;
        empty_world(&world);
        put_sphere(&world, vec3_of(0, -size, 0), size, surface_of(dull().color, 0.5, 0.4, 3));
        put_sphere(&world, vec3_of(0, above * size, 0), above / 2 * size, dull());
        put_light(&world, LIGHT_DISTANT, vec3_of(0, 1, 0), yellow);
        put_light(&world, LIGHT_DISTANT, at_60_degrees, blue);
        vec3 eye = 0.5 * size * vec3_of(-at_60_degrees[0], at_60_degrees[1], 0);
        Ray ray = {eye, -eye};
        expect_shade(&world, ray, (Hit){1, 0},
                     ambient_of(&world, 0) + diffuse(0.5, blue) + 0.4 * blue);
    }
}
END_TEST

START_TEST(any_lights_on_any_spheres_give_what_geometry_says)
{
    for (int i = 0; i < 40;) {
        double size = random_size(1e6);
        Color expected;
        Hit hit;
        random_world(&world, 4, 3, size);
        Ray ray = random_view(&world, size);
        if (!exact_hit(&world, ray, &hit) || !exact_shade(&world, ray, &expected))
            continue;
        expect_shade(&world, ray, hit, expected);
        i++;
    }
}
END_TEST

// ---- trace_ray ----------------------------------------------------------------------------------

// A gap of 1e-5 of the radius between two spheres, along whose axis the eye looks from inside the
// gap.
START_TEST(mirrors_may_be_close_together_in_scenes_of_any_size)
{
    for (int i = 8; i >= -6; i -= 2) {
        double size = pow(10, i);
        empty_world(&world);
        put_sphere(&world, vec3_of(0, 0, -1.000005 * size), size, mirror(yellow, 0.5));
        put_sphere(&world, vec3_of(0, 0, 1.000005 * size), size, mirror(blue, 0.25));
        expect_trace(&world, (Ray){vec3_of(0, 0, 0), vec3_of(0, 0, -size)}, 4,
                     to_and_fro(ambient_of(&world, 0), 0.5, ambient_of(&world, 1), 0.25, 4));
    }
}
END_TEST

// A single ball mirrors everything except itself, even if the eye is close to it and the origin of
// the world is far away.
START_TEST(a_ball_does_not_see_itself)
{
    for (int i = 0; i < 40; i++) {
        double size = random_size(1e6), away = pow(10, i % 2 == 0 ? 5 : random_number(0, 5));
        empty_world(&world);
        world.scene.background = random_scene_color();
        vec3 center = size * away * random_unit();
        double ks = random_number(0.2, 0.9);
        put_sphere(&world, center, size, mirror(random_scene_color(), ks));
        double distance = 1 + (i % 2 == 0 ? 1e-6 : random_number(0.1, 9));
        vec3 from = center + distance * size * random_unit();
        vec3 at = center + 0.6 * size * random_unit();
        expect_trace(&world, (Ray){from, at - from}, 1 + i % 3,
                     ambient_of(&world, 0) + ks * world.scene.background);
    }
}
END_TEST

START_TEST(on_any_axis_and_in_any_light_mirrors_face_each_other)
{
    for (int i = 0; i < 20; i++) {
        double size = random_size(1e6), ks = random_number(0.2, 0.9);
        double other_ks = random_number(0.2, 0.9);
        vec3 eye = size * random_vec3(-5, 5), axis = random_unit();
        double radius = random_number(0.5, 3), other_radius = random_number(0.5, 3);
        double away = radius + random_number(1, 4), other_away = other_radius + random_number(1, 4);
        Color light = random_scene_color();
        empty_world(&world);
        world.scene.ambient = random_scene_color();
        world.scene.background = random_scene_color();
        put_sphere(&world, eye + size * away * axis, size * radius,
                   mirror(random_scene_color(), ks));
        put_sphere(&world, eye - size * other_away * axis, size * other_radius,
                   mirror(random_scene_color(), other_ks));
        put_light(&world, LIGHT_POINT, eye, light);
        int depth = i % 4;
        Ray ray = {eye, size * random_number(0.1, 9) * axis};
        expect_trace(&world, ray, depth,
                     to_and_fro(lit_from_the_eye(&world, 0, light), ks,
                                lit_from_the_eye(&world, 1, light), other_ks, depth));
    }
}
END_TEST

START_TEST(any_mirrors_show_what_geometry_says)
{
    for (int i = 0; i < 40;) {
        double size = random_size(1e6);
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

// ---- no limit is right: how many, how near, how far, how deep or how weak ---------------------

// Ladders: an answer with a limit fails at the first rung after it, and that rung names the limit.
// Any number of things is allowed: first as many as an answer with a fixed size has room for, and
// then one more.

static const vec3 onward = {0, 0, 1};

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

// One sphere whose near side is at this distance, a tenth of that large.
static void one_sphere(double t)
{
    empty_world(&world);
    put_sphere(&world, 1.1 * t * onward, 0.1 * t, dull());
}

START_TEST(a_sphere_hides_a_light_however_near_it_is)
{
    for (int i = 0; i < RUNGS; i++) {
        one_sphere(down(i));
        expect_visible(&world, origin, light_at(LIGHT_POINT, onward), 0);
        expect_visible(&world, origin, light_at(LIGHT_DISTANT, onward), 0);
    }
}
END_TEST

START_TEST(a_sphere_hides_a_light_beyond_it_however_far_it_is)
{
    for (int i = 0; i < RUNGS; i++) {
        one_sphere(up(i));
        expect_visible(&world, origin, light_at(LIGHT_DISTANT, onward), 0);
        expect_visible(&world, origin, light_at(LIGHT_POINT, 2 * up(i) * onward), 0);
        expect_visible(&world, origin, light_at(LIGHT_POINT, 0.9 * up(i) * onward), 1);
    }
}
END_TEST

START_TEST(a_sphere_in_between_hides_a_light_at_any_distance)
{
    for (int i = 0; i < RUNGS; i++) {
        one_sphere(1);
        expect_visible(&world, origin, light_at(LIGHT_DISTANT, down(i) * onward), 0);
        expect_visible(&world, origin, light_at(LIGHT_DISTANT, up(i) * onward), 0);
        expect_visible(&world, origin, light_at(LIGHT_POINT, up(i) * onward), 0);
    }
}
END_TEST

// By a part of the radius that is ten times the allowed error of a hit: the surface is that close
// in front of the light, or beyond it. The farther the light, the smaller that is compared with the
// way to it.
START_TEST(a_sphere_just_in_front_of_a_light_hides_it_and_one_just_behind_does_not)
{
    for (int i = 0; i < 6; i++) {
        double away = i < 3 ? 10 : 900, gap = pow(10, -3 - i % 3);
        empty_world(&world);
        put_sphere(&world, (away + 1 - gap) * onward, 1, dull());
        expect_visible(&world, origin, light_at(LIGHT_POINT, away * onward), 0);
        empty_world(&world);
        put_sphere(&world, (away + 1 + gap) * onward, 1, dull());
        expect_visible(&world, origin, light_at(LIGHT_POINT, away * onward), 1);
    }
}
END_TEST

static const int rooms[] = {8, 10, 16, 20, 32, 50, 64, 100, 128, 256};
enum { ROOMS = sizeof rooms / sizeof *rooms };

START_TEST(the_last_of_any_number_of_spheres_hides_a_light)
{
    for (int i = 0; i <= 2 * ROOMS; i++) {
        int count = i < 2 * ROOMS ? rooms[i / 2] + i % 2 : MOST_SPHERES;
        empty_world(&world);
        for (int k = 1; k < count; k++)
            put_sphere(&world, vec3_of(2 + k, 3, 9), 1, dull());
        put_sphere(&world, 5 * onward, 1, dull());
        expect_visible(&world, origin, light_at(LIGHT_POINT, 10 * onward), 0);
    }
}
END_TEST

// ---- shade --------------------------------------------------------------------------------------

static Surface shiny(double kd, double ks, double shine)
{
    return surface_of(vec3_of(0.8, 0.6, 0.4), kd, ks, shine);
}

// The highest point of a sphere of radius 1 is the origin of the world.
static void surface_seen_from_above(Surface surface)
{
    empty_world(&world);
    put_sphere(&world, vec3_of(0, -1, 0), 1, surface);
}

static Color ambient_seen(void)
{
    return ambient_of(&world, 0);
}

// Straight above, where the light has its full effect: the colour of each light is its number.
START_TEST(the_last_of_any_number_of_lights_counts)
{
    static const int most[] = {2, 3, 4, 5, 8, 10, 16, 20, 32};
    for (int i = 0; i < 18; i++) {
        int count = most[i / 2] + i % 2;
        Color sum = vec3_of(0, 0, 0);
        surface_seen_from_above(shiny(0.5, 0.4, 3));
        for (int k = 0; k < count; k++) {
            Color color = (k == count - 1 ? 0.5 : 0.01) * vec3_of(0.9, 0.7, 0.5);
            sum += color;
            put_light(&world, k % 2 == 0 ? LIGHT_POINT : LIGHT_DISTANT, vec3_of(0, 9 + k, 0),
                      color);
        }
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient_seen() + 0.5 * vec3_of(0.8, 0.6, 0.4) * sum + 0.4 * sum);
    }
}
END_TEST

START_TEST(light_of_any_strength_is_scattered_and_mirrored)
{
    for (int i = 0; i < 2 * RUNGS; i++) {
        double strength = i < RUNGS ? down(i) : up(i - RUNGS);
        Color color = strength * vec3_of(0.9, 0.7, 0.5);
        surface_seen_from_above(shiny(0.5, 0.4, 3));
        world.scene.ambient *= strength;
        world.scene.background *= strength;
        put_light(&world, LIGHT_POINT, vec3_of(0, 9, 0), color);
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient_seen() + 0.5 * vec3_of(0.8, 0.6, 0.4) * color + 0.4 * color);
    }
}
END_TEST

// 0.3, 0.03 ... 3e-7, above the horizon of a white light.
enum { SMALL = 7 };

START_TEST(a_light_is_scattered_however_low_it_is)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = down(i) / hypot(1, down(i));
        surface_seen_from_above(shiny(0.5, 0, 3));
        put_light(&world, LIGHT_DISTANT, vec3_of(1, down(i), 0), white);
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient_seen() + 0.5 * cosine * vec3_of(0.8, 0.6, 0.4));
    }
}
END_TEST

START_TEST(a_surface_counts_however_little_it_reflects)
{
    for (int i = 0; i < SMALL; i++) {
        surface_seen_from_above(shiny(0.5, down(i), 3));
        put_light(&world, LIGHT_DISTANT, vec3_of(0, 1, 0), white);
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient_seen() + 0.5 * vec3_of(0.8, 0.6, 0.4) + down(i) * white);
        surface_seen_from_above(shiny(down(i), 0.4, 3));
        put_light(&world, LIGHT_DISTANT, vec3_of(0, 1, 0), white);
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient_seen() + down(i) * vec3_of(0.8, 0.6, 0.4) + 0.4 * white);
    }
}
END_TEST

// From straight above the highlight is all of ks, whatever its power; at 60 degrees 2^-shine of it.
START_TEST(a_surface_has_its_own_shine)
{
    const double shines[] = {0, 0.5, 1, 2, 10, 20};
    for (int i = 0; i < 6; i++) {
        surface_seen_from_above(shiny(0.5, 0.4, shines[i]));
        put_light(&world, LIGHT_DISTANT, vec3_of(0.86602540378443864676, 0.5, 0), white);
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient_seen() + 0.25 * vec3_of(0.8, 0.6, 0.4) +
                         0.4 * pow(2, -shines[i]) * white);
    }
}
END_TEST

START_TEST(at_any_t_a_surface_is_lit)
{
    for (int i = 0; i < 2 * RUNGS; i++) {
        double t = i < RUNGS ? down(i) : up(i - RUNGS);
        surface_seen_from_above(shiny(0.5, 0.4, 3));
        put_light(&world, LIGHT_POINT, vec3_of(0, 9, 0), white);
        expect_shade(&world, (Ray){vec3_of(0, 4, 0), vec3_of(0, -4 / t, 0)}, (Hit){t, 0},
                     ambient_seen() + 0.5 * vec3_of(0.8, 0.6, 0.4) + 0.4 * white);
    }
}
END_TEST

// ---- trace_ray ----------------------------------------------------------------------------------

// Two mirrors on the axis, 4 in front of the eye and 6 behind it.
static void facing(double ks, double other_ks)
{
    empty_world(&world);
    put_sphere(&world, vec3_of(0, 0, 5), 1, mirror(vec3_of(0.2, 0.9, 0.3), ks));
    put_sphere(&world, vec3_of(0, 0, -8), 2, mirror(vec3_of(0.9, 0.4, 0.6), other_ks));
}

START_TEST(mirrors_are_followed_as_deep_as_depth_says)
{
    static const int depths[] = {2, 3, 4, 5, 6, 8, 10, 15, 16, 20, 30, 32, 50, 64, 99, 100, 128};
    for (int i = 0; i < 34; i++) {
        int depth = depths[i / 2] + i % 2;
        facing(1, 1);
        expect_trace(&world, (Ray){origin, 2 * onward}, depth,
                     to_and_fro(ambient_of(&world, 0), 1, ambient_of(&world, 1), 1, depth));
    }
}
END_TEST

START_TEST(a_mirror_counts_however_weak_it_is)
{
    for (int i = 0; i < SMALL; i++) {
        empty_world(&world);
        world.scene.background = white;
        put_sphere(&world, vec3_of(0, 0, 5), 1, mirror(vec3_of(0.2, 0.9, 0.3), down(i)));
        expect_trace(&world, (Ray){origin, 2 * onward}, 3, ambient_of(&world, 0) + down(i) * white);
    }
}
END_TEST

// In each other they show less and less: 0.04, 0.0016 ... 3e-7 of the light.
START_TEST(light_through_many_mirrors_counts_however_little_it_is)
{
    for (int depth = 0; depth <= 5; depth++) {
        facing(0.04, 0.04);
        world.scene.ambient = 3 * white;
        expect_trace(&world, (Ray){origin, 2 * onward}, depth,
                     to_and_fro(ambient_of(&world, 0), 0.04, ambient_of(&world, 1), 0.04, depth));
    }
}
END_TEST

START_TEST(at_any_t_there_is_a_mirror)
{
    for (int i = 0; i < 2 * RUNGS; i++) {
        facing(0.5, 0.25);
        expect_trace(&world, (Ray){origin, (i < RUNGS ? down(i) : up(i - RUNGS)) * onward}, 2,
                     to_and_fro(ambient_of(&world, 0), 0.5, ambient_of(&world, 1), 0.25, 2));
    }
}
END_TEST

START_TEST(the_last_of_any_number_of_spheres_is_mirrored)
{
    for (int i = 0; i <= 2 * ROOMS; i++) {
        int count = i < 2 * ROOMS ? rooms[i / 2] + i % 2 : MOST_SPHERES;
        facing(0.5, 0);
        world.scene.sphere_count = 1;
        for (int k = 2; k < count; k++)
            put_sphere(&world, vec3_of(2 + k, 3, 0), 1, dull());
        put_sphere(&world, vec3_of(0, 0, -8), 2, dull());
        expect_trace(&world, (Ray){origin, 2 * onward}, 1,
                     ambient_of(&world, 0) + 0.5 * ambient_of(&world, count - 1));
    }
}
END_TEST

void list_tests_with_scenes(void)
{
    tests_of("off_surface");
    test(outside_the_point_moves_away_from_the_centre);
    test(inside_the_point_moves_towards_the_centre);
    test(scenes_may_be_of_any_size);
    test(a_small_sphere_far_away_needs_as_large_a_step_as_a_large_one);
    test(negative_coordinates_are_as_large_as_positive_ones);
    test(around_the_origin_of_the_world_the_radius_counts);
    test(anywhere_it_is_a_step_along_the_normal);
    tests_of("visibility");
    test(in_an_empty_scene_light_arrives);
    test(a_sphere_in_between_hides_a_light);
    test(a_sphere_beside_the_way_hides_nothing);
    test(the_way_to_a_point_light_starts_at_the_point);
    test(a_sphere_behind_a_point_light_hides_nothing);
    test(a_sphere_far_from_the_point_but_in_front_of_the_light_hides_it);
    test(a_sphere_behind_the_point_hides_nothing);
    test(a_distant_light_is_beyond_everything);
    test(how_long_the_direction_of_a_distant_light_is_does_not_matter);
    test(the_first_of_many_spheres_is_enough);
    test(the_last_of_many_spheres_is_enough);
    test(one_among_many_spheres_is_enough);
    test(two_spheres_hide_a_light_no_more_than_one);
    test(of_spheres_only_those_in_between_count);
    test(from_inside_a_sphere_only_lights_inside_it_are_seen);
    test(a_light_inside_a_sphere_is_not_seen_from_outside);
    test(a_sphere_close_to_the_point_also_hides_a_light);
    test(a_sphere_close_to_a_light_also_hides_it);
    test(glass_hides_a_light_like_anything_else);
    test(in_an_eclipse_the_shadow_is_a_cone);
    test(any_spheres_hide_any_light_as_geometry_says);
    test(a_sphere_hides_a_light_however_near_it_is);
    test(a_sphere_hides_a_light_beyond_it_however_far_it_is);
    test(a_sphere_in_between_hides_a_light_at_any_distance);
    test(a_sphere_just_in_front_of_a_light_hides_it_and_one_just_behind_does_not);
    test(the_last_of_any_number_of_spheres_hides_a_light);
    tests_of("shade");
    test(without_lights_only_ambient_light_is_left);
    test(a_light_straight_above_has_its_full_effect);
    test(a_dull_surface_has_no_highlight);
    test(a_light_at_an_angle_has_less_of_both_terms);
    test(the_highlight_is_where_the_mirrored_light_meets_the_eye);
    test(if_the_mirrored_light_goes_away_from_the_eye_there_is_no_highlight);
    test(lights_add_up);
    test(in_the_shadow_the_ambient_light_is_left);
    test(a_light_that_is_hidden_takes_nothing_from_the_others);
    test(a_sphere_behind_a_light_or_beside_it_makes_no_shadow);
    test(a_surface_that_is_turned_away_from_the_light_is_in_its_own_shadow);
    test(bright_light_is_not_clamped);
    test(the_surface_is_that_of_the_sphere_that_was_hit);
    test(how_long_the_direction_of_the_ray_is_does_not_change_the_shade);
    test(inside_a_sphere_the_normal_points_to_the_eye);
    test(a_hit_that_rounding_put_just_inside_the_sphere_is_lit);
    test(a_tiny_sphere_close_to_the_surface_casts_its_shadow);
    test(any_lights_on_any_spheres_give_what_geometry_says);
    test(the_last_of_any_number_of_lights_counts);
    test(light_of_any_strength_is_scattered_and_mirrored);
    test(a_light_is_scattered_however_low_it_is);
    test(a_surface_counts_however_little_it_reflects);
    test(a_surface_has_its_own_shine);
    test(at_any_t_a_surface_is_lit);
    tests_of("trace_ray");
    test(if_nothing_is_hit_the_background_is_seen);
    test(at_depth_0_a_mirror_shows_only_itself);
    test(a_surface_without_specular_is_not_a_mirror);
    test(a_mirror_also_shows_the_background);
    test(one_mirror_shows_the_other);
    test(mirrors_that_face_each_other_are_seen_as_often_as_depth_says);
    test(a_perfect_mirror_loses_no_light);
    test(objects_in_a_mirror_are_lit_as_usual);
    test(bright_light_is_not_clamped_in_mirrors_either);
    test(the_angle_out_is_the_angle_in);
    test(how_long_the_direction_of_the_ray_is_does_not_matter);
    test(inside_a_hollow_mirror_a_ray_stays_inside);
    test(mirrors_may_be_close_together_in_scenes_of_any_size);
    test(a_ball_does_not_see_itself);
    test(on_any_axis_and_in_any_light_mirrors_face_each_other);
    test(any_mirrors_show_what_geometry_says);
    test(mirrors_are_followed_as_deep_as_depth_says);
    test(a_mirror_counts_however_weak_it_is);
    test(light_through_many_mirrors_counts_however_little_it_is);
    test(at_any_t_there_is_a_mirror);
    test(the_last_of_any_number_of_spheres_is_mirrored);
}
