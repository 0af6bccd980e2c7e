// 07-shading-scene-shade.c - tests of shade: what each light gives, by hand.
#include "tests/07-shading-scene.h"

// A sphere of radius 1 whose highest point is the origin of the world, seen from straight above:
// there the normal is up, and so is the way to the eye. Ambient is 0.5 * (0.8, 0.6, 0.4) times the
// ambient light.
#define EYE_ABOVE ((Ray){vec3_of(0, 4, 0), vec3_of(0, -2, 0)})
#define HIT_AT_2 ((Hit){2, 0})
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

START_TEST(without_lights_there_is_the_ambient_light_of_the_scene)
{
    world_seen_from_above(0.4, 3);
    expect_shade(&world, EYE_ABOVE, HIT_AT_2, ambient);
    world.scene.ambient = vec3_of(1, 0.5, 0);
    expect_shade(&world, EYE_ABOVE, HIT_AT_2, vec3_of(0.4, 0.15, 0));
}
END_TEST

START_TEST(a_light_straight_above_gives_all_that_it_can)
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
START_TEST(aslant_there_is_less_of_both)
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

START_TEST(where_the_mirrored_light_goes_away_from_the_eye_there_is_no_highlight)
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

START_TEST(what_is_behind_a_light_or_beside_makes_no_shadow)
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

START_TEST(how_long_the_direction_of_the_ray_is_does_not_matter)
{
    const double lengths[] = {0.01, 1, 8, 4000};
    world_seen_from_above(0.4, 3);
    put_light(&world, LIGHT_POINT, at_60_degrees, yellow);
    for (int i = 0; i < 4; i++)
        expect_shade(&world, (Ray){vec3_of(0, 4, 0), vec3_of(0, -lengths[i], 0)},
                     (Hit){4 / lengths[i], 0}, ambient + diffuse(0.5, yellow) + 0.4 / 8 * yellow);
}
END_TEST

// Eye and light in a hollow sphere round the origin, opposite the point: it is turned to them.
START_TEST(inside_a_sphere_the_surface_is_turned_to_the_eye)
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

void list_tests_of_shade(void)
{
    tests_of("shade");
    test(without_lights_there_is_the_ambient_light_of_the_scene);
    test(a_light_straight_above_gives_all_that_it_can);
    test(a_dull_surface_has_no_highlight);
    test(aslant_there_is_less_of_both);
    test(the_highlight_is_where_the_mirrored_light_meets_the_eye);
    test(where_the_mirrored_light_goes_away_from_the_eye_there_is_no_highlight);
    test(lights_add_up);
    test(in_the_shadow_the_ambient_light_is_left);
    test(a_light_that_is_hidden_takes_nothing_from_the_others);
    test(what_is_behind_a_light_or_beside_makes_no_shadow);
    test(a_surface_that_is_turned_away_from_the_light_is_in_its_own_shadow);
    test(bright_light_is_not_clamped);
    test(the_surface_is_that_of_the_sphere_that_was_hit);
    test(how_long_the_direction_of_the_ray_is_does_not_matter);
    test(inside_a_sphere_the_surface_is_turned_to_the_eye);
    list_more_tests_of_shade();
    list_limits_of_shade();
}
