// 07-shading-scene-any.c - tests of shadows, shade and mirrors in scenes of any size, and in random
// ones.
//
// What is seen in a mirror must not depend on how far a right answer goes off its surface: random
// mirrors face each other on an axis, or their colours are ambient only.
#include "tests/07-shading-scene.h"

static World world;

// ---- visibility ---------------------------------------------------------------------------------

// The shadow of a sphere in the light of a point is a cone: its half angle has the sine
// radius / distance. Places behind the sphere, a little inside that cone and a little outside.
START_TEST(in_an_eclipse_the_shadow_is_a_cone)
{
    for (int i = 0; i < 20; i++) {
        empty_world(&world);
        double scale = random_size(1e6), moon = random_number(0.2, 2), away = random_number(3, 9);
        vec3 sun = random_vec3(-5, 5), axis = random_unit();
        vec3 aside = vec3_unit(vec3_cross(axis, random_unit()));
        double sine = moon / away, tangent = sine / sqrt(1 - sine * sine);
        double behind = away + random_number(2.1, 9);
        put_sphere(&world, (sun + away * axis) * scale, moon * scale, dull());
        Light light = {.position = sun * scale, .color = {1, 1, 1}, .kind = LIGHT_POINT};
        for (int k = 0; k < 2; k++) {
            double within = k == 0 ? random_number(0, 0.99) : random_number(1.01, 1.3);
            vec3 place = sun + behind * axis + within * behind * tangent * aside;
            expect_visible(&world, place * scale, light, k);
        }
    }
}
END_TEST

START_TEST(any_spheres_hide_any_light_as_geometry_has_it)
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

// On top of a sphere, lit at 60 degrees to the normal.
static const vec3 at_60_degrees = {8.6602540378443864676, 5, 0};
static const Color yellow = {0.9, 0.7, 0.1}, blue = {0.1, 0.2, 0.8};

static Color diffuse(double cosine, Color light)
{
    return 0.5 * cosine * dull().color * light;
}

// A hit is right to within rounding only. So short of the surface or behind it are 5e-11 of the
// radius, less than off_surface goes at least.
START_TEST(a_hit_that_rounding_put_a_hair_inside_the_sphere_is_lit)
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

// The crumb is so many radii above it, and half as large: in the way of the light from above,
// beside the way of the other, whose mirror image meets the eye.
START_TEST(a_crumb_close_to_the_surface_casts_its_shadow)
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

// Whatever a ball alone mirrors is not itself, also where the eye is close to it and the origin of
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

void list_more_tests_of_visibility(void)
{
    test(in_an_eclipse_the_shadow_is_a_cone);
    test(any_spheres_hide_any_light_as_geometry_has_it);
}

void list_more_tests_of_shade(void)
{
    test(a_hit_that_rounding_put_a_hair_inside_the_sphere_is_lit);
    test(a_crumb_close_to_the_surface_casts_its_shadow);
    test(any_lights_on_any_spheres_give_what_geometry_says);
}

void list_more_tests_of_trace_ray(void)
{
    test(mirrors_may_be_close_together_in_scenes_of_any_size);
    test(a_ball_does_not_see_itself);
    test(on_any_axis_and_in_any_light_mirrors_face_each_other);
    test(any_mirrors_show_what_geometry_says);
}
