// 07-shading-terms.c - tests of the ambient and the diffuse term.
#include "tests/07-shading.h"

// ---- ambient_term -------------------------------------------------------------------------------

void expect_ambient(Color surface, double kd, Color ambient, Color color)
{
    given_color("surface", surface);
    given_number("kd", kd);
    given_color("ambient", ambient);
    expect_vec3(ambient_term(surface, kd, ambient), color, TOLERANCE * largest(ambient));
}

START_TEST(in_white_ambient_light_there_is_kd_of_the_surface)
{
    Color surface = vec3_of(0.8, 0.4, 0.2);
    expect_ambient(surface, 1, vec3_of(1, 1, 1), vec3_of(0.8, 0.4, 0.2));
    expect_ambient(surface, 0.5, vec3_of(1, 1, 1), vec3_of(0.4, 0.2, 0.1));
    expect_ambient(surface, 0.5, vec3_of(0.1, 0.1, 0.1), vec3_of(0.04, 0.02, 0.01));
}
END_TEST

// By hand: 0.5 * 0.8 * 0.1, 0.5 * 0.5 * 0.2, 0.5 * 0.2 * 0.6.
START_TEST(ambient_light_is_multiplied_colour_by_colour)
{
    expect_ambient(vec3_of(0.8, 0.5, 0.2), 0.5, vec3_of(0.1, 0.2, 0.6), vec3_of(0.04, 0.05, 0.06));
    expect_ambient(vec3_of(1, 0, 0), 0.5, vec3_of(0, 1, 1), vec3_of(0, 0, 0));
}
END_TEST

START_TEST(without_ambient_light_nothing_is_there)
{
    expect_ambient(vec3_of(0.8, 0.5, 0.2), 0.5, vec3_of(0, 0, 0), vec3_of(0, 0, 0));
}
END_TEST

START_TEST(much_ambient_light_may_be_brighter_than_white)
{
    expect_ambient(vec3_of(0.9, 0.5, 0.1), 1, vec3_of(4, 3, 2), vec3_of(3.6, 1.5, 0.2));
}
END_TEST

// What comes out is chosen, and the ambient light made to fit.
START_TEST(an_ambient_term_that_was_chosen_comes_back)
{
    for (int i = 0; i < 20; i++) {
        Color surface = random_color(0.3, 1), color = random_color(0, 1);
        double kd = random_number(0.2, 1);
        Color ambient =
            vec3_of(color[0] / surface[0], color[1] / surface[1], color[2] / surface[2]);
        expect_ambient(surface, kd, ambient / kd, color);
    }
}
END_TEST

// ---- diffuse_term -------------------------------------------------------------------------------

void expect_diffuse(Color surface, double kd, Color light, vec3 normal, vec3 to_light, Color color)
{
    given_color("surface", surface);
    given_number("kd", kd);
    given_color("light", light);
    given_vec3("normal", normal);
    given_vec3("to light", to_light);
    expect_vec3(diffuse_term(surface, kd, light, normal, to_light), color,
                TOLERANCE * largest(light));
}

static const vec3 up = {0, 1, 0};

// A surface that has all of a white light: what comes out is the share that arrives.
static void expect_share(vec3 to_light, double share)
{
    expect_diffuse(vec3_of(1, 1, 1), 1, vec3_of(1, 1, 1), up, to_light, share * vec3_of(1, 1, 1));
}

START_TEST(light_from_straight_above_is_scattered_in_full)
{
    expect_share(vec3_of(0, 1, 0), 1);
    expect_share(vec3_of(0, 7, 0), 1);
}
END_TEST

// 3, 4, 5: the cosine is 4 / 5 where the light is high, and 3 / 5 where it is low.
START_TEST(the_lower_the_light_the_less_is_scattered)
{
    expect_share(vec3_of(0.6, 0.8, 0), 0.8);
    expect_share(vec3_of(0, 0.6, -0.8), 0.6);
    expect_share(vec3_of(-0.96, 0.28, 0), 0.28);
    expect_share(vec3_of(1, 0, 0), 0);
}
END_TEST

START_TEST(a_light_twice_as_far_in_the_same_direction_scatters_as_much)
{
    double length[] = {5, 10, 500, 0.05};
    for (int i = 0; i < 4; i++)
        expect_share(length[i] * vec3_of(0.6, 0.8, 0), 0.8);
}
END_TEST

START_TEST(a_light_behind_the_surface_scatters_nothing)
{
    expect_share(vec3_of(0, -1, 0), 0);
    expect_share(vec3_of(6, -8, 0), 0);
    expect_diffuse(vec3_of(0.8, 0.5, 0.2), 0.5, vec3_of(1, 0.4, 0.5), vec3_of(-2, -1, 2) / 3,
                   vec3_of(3, 4, 1), vec3_of(0, 0, 0));
}
END_TEST

// By hand: (-1, 2, 2) / 3 and (3, 0, 4) / 5 have the cosine (-3 + 8) / 15 = 1 / 3; then 0.6 / 3 is
// 0.2, times 0.8 * 0.5, 0.5 * 1, 0.2 * 2.
START_TEST(light_is_multiplied_colour_by_colour)
{
    expect_diffuse(vec3_of(0.8, 0.5, 0.2), 0.6, vec3_of(0.5, 1, 2), vec3_of(-1, 2, 2) / 3,
                   vec3_of(3, 0, 4), vec3_of(0.08, 0.1, 0.08));
    expect_diffuse(vec3_of(1, 0, 0), 0.6, vec3_of(0, 1, 1), up, vec3_of(1, 5, 1), vec3_of(0, 0, 0));
}
END_TEST

START_TEST(a_bright_light_may_be_scattered_brighter_than_white)
{
    expect_diffuse(vec3_of(0.9, 0.5, 0.1), 1, vec3_of(8, 8, 8), up, vec3_of(0, 3, 4),
                   vec3_of(4.32, 2.4, 0.48));
}
END_TEST

START_TEST(at_an_angle_that_was_chosen_its_cosine_is_scattered)
{
    for (int i = 0; i < 30; i++) {
        Color surface = random_color(0.2, 1), light = random_color(0.2, 2);
        double kd = random_number(0.2, 1), degrees = random_number(0, 180);
        vec3 normal = random_unit(), to_light = turned(normal, degrees, random_across(normal));
        double share = degrees < 90 ? kd * cos(degrees * PI / 180) : 0;
        expect_diffuse(surface, kd, light, normal, random_number(0.1, 10) * to_light,
                       vec3_of(share * surface[0] * light[0], share * surface[1] * light[1],
                               share * surface[2] * light[2]));
    }
}
END_TEST

void list_tests_of_terms(void)
{
    tests_of("ambient_term");
    test(in_white_ambient_light_there_is_kd_of_the_surface);
    test(ambient_light_is_multiplied_colour_by_colour);
    test(without_ambient_light_nothing_is_there);
    test(much_ambient_light_may_be_brighter_than_white);
    test(an_ambient_term_that_was_chosen_comes_back);
    list_more_of_ambient_term();

    tests_of("diffuse_term");
    test(light_from_straight_above_is_scattered_in_full);
    test(the_lower_the_light_the_less_is_scattered);
    test(a_light_twice_as_far_in_the_same_direction_scatters_as_much);
    test(a_light_behind_the_surface_scatters_nothing);
    test(light_is_multiplied_colour_by_colour);
    test(a_bright_light_may_be_scattered_brighter_than_white);
    test(at_an_angle_that_was_chosen_its_cosine_is_scattered);
    list_more_of_diffuse_term();
}
