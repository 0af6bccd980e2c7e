// 07-shading-shadow.c - tests of visibility: what is between a place and a light.
//
// Expected: by hand, mostly on an axis. More of them, random ones, are in 07-shading-scene-any.c.
#include "tests/07-shading-scene.h"

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

START_TEST(where_there_is_nothing_light_arrives)
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

START_TEST(a_sphere_beside_hides_nothing)
{
    expect_visible(sphere_on_the_axis(5, 1), vec3_of(1.5, 0, 0), point_light(1.5, 0, 10), 1);
    expect_visible(sphere_on_the_axis(5, 1), vec3_of(1.5, 0, 0), distant_light(0, 0, 10), 1);
    // The direction counts, not where its tip is.
    expect_visible(sphere_on_the_axis(5, 1), vec3_of(0, 4, 0), distant_light(0, 0, 5), 1);
}
END_TEST

// Seen from (0, 6, 0) the light is beyond the sphere; the way to its coordinates is another.
START_TEST(the_way_to_a_point_light_begins_at_the_place)
{
    expect_visible(sphere_on_the_axis(4, 1), vec3_of(0, 6, 0), point_light(0, -6, 8), 0);
    expect_visible(sphere_on_the_axis(4, 1), vec3_of(0, 6, 0), point_light(0, 0, 8), 1);
}
END_TEST

// By chance these are 1 in lengths of the way to the light; that of (0, 0, 4) is 4 long.
START_TEST(what_is_behind_a_point_light_hides_nothing)
{
    expect_visible(sphere_on_the_axis(6, 1), origin, point_light(0, 0, 4), 1);
    expect_visible(sphere_on_the_axis(0.5, 0.1), origin, point_light(0, 0, 0.25), 1);
    expect_visible(sphere_on_the_axis(5.5, 1), origin, point_light(0, 0, 4), 1);
}
END_TEST

START_TEST(what_is_far_from_the_place_but_before_the_light_hides_it)
{
    expect_visible(sphere_on_the_axis(9e5, 1e4), origin, point_light(0, 0, 1e6), 0);
    expect_visible(sphere_on_the_axis(9e-5, 1e-6), origin, point_light(0, 0, 1e-4), 0);
}
END_TEST

START_TEST(what_is_behind_the_place_hides_nothing)
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

// The nearest of all is no help: it is behind the light, beside the way or before the place.
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

START_TEST(what_is_close_to_the_place_hides_a_light_too)
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

START_TEST(what_is_close_to_a_light_hides_it_too)
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
    given("made so", "that the sphere lets 0.8 of the light through");
    expect_visible(&world, origin, point_light(0, 0, 10), 0);
}
END_TEST

void list_tests_of_visibility(void)
{
    tests_of("visibility");
    test(where_there_is_nothing_light_arrives);
    test(a_sphere_in_between_hides_a_light);
    test(a_sphere_beside_hides_nothing);
    test(the_way_to_a_point_light_begins_at_the_place);
    test(what_is_behind_a_point_light_hides_nothing);
    test(what_is_far_from_the_place_but_before_the_light_hides_it);
    test(what_is_behind_the_place_hides_nothing);
    test(a_distant_light_is_beyond_everything);
    test(how_long_the_direction_of_a_distant_light_is_does_not_matter);
    test(the_first_of_many_spheres_is_enough);
    test(the_last_of_many_spheres_is_enough);
    test(one_among_many_spheres_is_enough);
    test(two_spheres_hide_a_light_no_more_than_one);
    test(of_spheres_only_those_in_between_count);
    test(from_inside_a_sphere_only_lights_inside_it_are_seen);
    test(a_light_inside_a_sphere_is_not_seen_from_outside);
    test(what_is_close_to_the_place_hides_a_light_too);
    test(what_is_close_to_a_light_hides_it_too);
    test(glass_hides_a_light_like_anything_else);
    list_more_tests_of_visibility();
    list_limits_of_visibility();
}
