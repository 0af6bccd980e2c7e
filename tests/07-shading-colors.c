// 07-shading-colors.c - tests of what a display gets: clamped, and encoded for its gamma.
#include "tests/07-shading.h"

// ---- clamp_color --------------------------------------------------------------------------------

void expect_clamped(Color color, Color clamped)
{
    given_color("colour", color);
    expect_vec3(clamp_color(color), clamped, TOLERANCE);
}

START_TEST(what_is_between_0_and_1_stays)
{
    expect_clamped(vec3_of(0.25, 0.5, 0.125), vec3_of(0.25, 0.5, 0.125));
    expect_clamped(vec3_of(0, 1, 0.999), vec3_of(0, 1, 0.999));
}
END_TEST

START_TEST(what_is_above_1_becomes_1_and_the_others_stay)
{
    expect_clamped(vec3_of(0.5, 300, 0.25), vec3_of(0.5, 1, 0.25));
    expect_clamped(vec3_of(1.5, 0.5, 0.25), vec3_of(1, 0.5, 0.25));
    expect_clamped(vec3_of(0.5, 0.25, 2), vec3_of(0.5, 0.25, 1));
    expect_clamped(vec3_of(1.1, 2.2, 3.3), vec3_of(1, 1, 1));
}
END_TEST

START_TEST(what_is_below_0_becomes_0_and_the_others_stay)
{
    expect_clamped(vec3_of(-0.5, -300, 0.25), vec3_of(0, 0, 0.25));
    expect_clamped(vec3_of(-0.25, 0.5, 0.75), vec3_of(0, 0.5, 0.75));
    expect_clamped(vec3_of(0.5, 0.25, -2), vec3_of(0.5, 0.25, 0));
    expect_clamped(vec3_of(-1.1, -2.2, -3.3), vec3_of(0, 0, 0));
}
END_TEST

START_TEST(each_number_is_clamped_by_itself)
{
    for (int i = 0; i < 20; i++) {
        double below = random_number(-3, 0), inside = random_number(0, 1);
        double above = random_number(1, 4);
        expect_clamped(vec3_of(below, inside, above), vec3_of(0, inside, 1));
        expect_clamped(vec3_of(above, below, inside), vec3_of(1, 0, inside));
        expect_clamped(vec3_of(inside, above, below), vec3_of(inside, 1, 0));
    }
}
END_TEST

// ---- gamma_encode -------------------------------------------------------------------------------

void expect_encoded(Color color, double gamma, Color encoded)
{
    given_color("colour", color);
    given_number("gamma", gamma);
    expect_vec3(gamma_encode(color, gamma), encoded, TOLERANCE);
}

START_TEST(with_a_gamma_of_1_nothing_changes)
{
    expect_encoded(vec3_of(0.25, 0.5, 0.75), 1, vec3_of(0.25, 0.5, 0.75));
}
END_TEST

// The display squares what it gets, so a quarter of the light wants half; and so on.
START_TEST(a_gamma_of_2_wants_the_square_root_and_3_the_cube_root)
{
    expect_encoded(vec3_of(0.25, 0.01, 0.81), 2, vec3_of(0.5, 0.1, 0.9));
    expect_encoded(vec3_of(0.125, 0.001, 0.512), 3, vec3_of(0.5, 0.1, 0.8));
    expect_encoded(vec3_of(0.5, 0.1, 0.9), 0.5, vec3_of(0.25, 0.01, 0.81));
}
END_TEST

START_TEST(black_stays_black_and_white_stays_white)
{
    double gamma[] = {0.5, 1, 1.8, 2.2, 3};
    for (int i = 0; i < 5; i++) {
        expect_encoded(vec3_of(0, 0, 0), gamma[i], vec3_of(0, 0, 0));
        expect_encoded(vec3_of(1, 1, 1), gamma[i], vec3_of(1, 1, 1));
    }
}
END_TEST

// With another program: 2.2nd roots.
START_TEST(a_gamma_of_2_2_as_most_displays_have_it)
{
    expect_encoded(vec3_of(0.2, 0.5, 0.8), 2.2,
                   vec3_of(0.4811565050522864, 0.7297400528407231, 0.9035454309190944));
}
END_TEST

START_TEST(what_the_display_makes_of_it_is_what_was_meant)
{
    for (int i = 0; i < 20; i++) {
        Color encoded = random_color(0.1, 1);
        double gamma = random_number(0.5, 4);
        Color meant =
            vec3_of(pow(encoded[0], gamma), pow(encoded[1], gamma), pow(encoded[2], gamma));
        expect_encoded(meant, gamma, encoded);
    }
}
END_TEST

void list_tests_of_colors(void)
{
    tests_of("clamp_color");
    test(what_is_between_0_and_1_stays);
    test(what_is_above_1_becomes_1_and_the_others_stay);
    test(what_is_below_0_becomes_0_and_the_others_stay);
    test(each_number_is_clamped_by_itself);
    list_more_of_clamp_color();

    tests_of("gamma_encode");
    test(with_a_gamma_of_1_nothing_changes);
    test(a_gamma_of_2_wants_the_square_root_and_3_the_cube_root);
    test(black_stays_black_and_white_stays_white);
    test(a_gamma_of_2_2_as_most_displays_have_it);
    test(what_the_display_makes_of_it_is_what_was_meant);
    list_more_of_gamma_encode();
}
