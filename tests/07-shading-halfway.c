// 07-shading-halfway.c - tests of the highlight by the half-way vector, Blinn's.
#include "tests/07-shading.h"

void expect_halfway(double ks, double shine, Color light, vec3 normal, vec3 to_light, vec3 to_eye,
                    Color color)
{
    given_highlight(ks, shine, light, normal, to_light, to_eye);
    expect_vec3(halfway_term(ks, shine, light, normal, to_light, to_eye), color,
                TOLERANCE * largest(light));
}

static const vec3 up = {0, 1, 0};

// All of a white light, over a surface that lies flat.
static void expect_share(double shine, vec3 to_light, vec3 to_eye, double share)
{
    expect_halfway(1, shine, vec3_of(1, 1, 1), up, to_light, to_eye, share * vec3_of(1, 1, 1));
}

START_TEST(where_the_normal_is_half_way_ks_of_the_light_is_seen)
{
    Color light = vec3_of(0.9, 0.7, 0.8);
    for (int shine = 1; shine < 100; shine *= 3) {
        expect_halfway(0.5, shine, light, up, vec3_of(0, 1, 0), vec3_of(0, 1, 0), light / 2);
        expect_halfway(0.5, shine, light, up, vec3_of(4, 3, 0), vec3_of(-4, 3, 0), light / 2);
        expect_halfway(0.5, shine, light, vec3_of(1, 0, 0), vec3_of(1, 2, 2), vec3_of(1, -2, -2),
                       light / 2);
    }
}
END_TEST

// Half-way between (0, 1, 0) and (24, 7, 0) / 25 is (3, 4, 0) / 5: twice (3, 4, 0) / 5 times the
// cosine 4 / 5 is their sum. Its cosine with the normal is 4 / 5.
START_TEST(the_cosine_with_the_normal_is_taken_to_the_power_of_shine)
{
    vec3 eye = vec3_of(0.96, 0.28, 0), eye_aside = vec3_of(0, 0.28, -0.96);
    expect_share(1, vec3_of(0, 1, 0), eye, 0.8);
    expect_share(2, vec3_of(0, 1, 0), eye, 0.64);
    expect_share(3, vec3_of(0, 1, 0), eye_aside, 0.512);
    expect_share(4, eye, vec3_of(0, 1, 0), 0.4096);
}
END_TEST

// Half-way between a direction and itself is that direction; the cosine of (12, 9, 20) / 25 with
// the normal is 9 / 25.
START_TEST(shine_need_not_be_a_whole_number_here_either)
{
    vec3 there = vec3_of(0.48, 0.36, 0.8);
    expect_share(0.5, there, there, 0.6);
    expect_share(1.5, there, there, 0.216);
    expect_share(2.5, there, there, 0.07776);
}
END_TEST

START_TEST(only_the_directions_of_light_and_eye_matter)
{
    double length[] = {5, 10, 500, 0.05};
    for (int i = 0; i < 4; i++) {
        expect_share(2, length[i] * vec3_of(0, 1, 0), vec3_of(0.96, 0.28, 0), 0.64);
        expect_share(2, vec3_of(0, 1, 0), length[i] * vec3_of(0.96, 0.28, 0), 0.64);
    }
}
END_TEST

START_TEST(this_highlight_too_has_the_colour_of_the_light)
{
    expect_halfway(0.5, 2, vec3_of(1, 0.5, 0), up, vec3_of(0, 1, 0), vec3_of(24, 7, 0),
                   vec3_of(0.32, 0.16, 0));
    expect_halfway(0.25, 1, vec3_of(8, 12, 0.2), up, vec3_of(0, 1, 0), vec3_of(24, 7, 0),
                   vec3_of(1.6, 2.4, 0.04));
}
END_TEST

// Half-way between (4, 3, 0) / 5 and the eye is below the surface: there the cosine is negative,
// its square is not.
START_TEST(half_way_below_the_surface_there_is_no_highlight)
{
    for (int shine = 1; shine <= 4; shine++) {
        expect_share(shine, vec3_of(4, 3, 0), vec3_of(0, -1, 0), 0);
        expect_share(shine, vec3_of(4, 3, 0), vec3_of(1, -4, 1), 0);
    }
    expect_share(2.5, vec3_of(4, 3, 0), vec3_of(1, -4, 1), 0);
}
END_TEST

START_TEST(from_behind_the_surface_comes_no_highlight)
{
    expect_share(2, vec3_of(4, -3, 0), vec3_of(-4, -3, 0), 0);
    expect_share(2, vec3_of(4, -3, 0), vec3_of(0, 1, 0), 0);
    expect_share(7, vec3_of(12, -3, 4), vec3_of(-3, 5, 1), 0);
}
END_TEST

// The half-way vector is at a chosen angle from the normal; light and eye are as far from it, on
// either side.
START_TEST(half_way_at_an_angle_that_was_chosen)
{
    for (int i = 0; i < 40; i++) {
        vec3 normal = random_unit();
        double off = random_number(0, 80), apart = random_number(5, 75);
        vec3 halfway = turned(normal, off, random_across(normal));
        vec3 across = random_across(halfway);
        vec3 to_light = turned(halfway, apart, across), to_eye = turned(halfway, -apart, across);
        double ks = random_number(0.1, 1), shine = random_number(0.5, 9);
        Color light = random_color(0.2, 2);
        double cosine = vec3_dot(normal, to_light);
        double share = cosine > 0 ? ks * pow(cos(off * PI / 180), shine) : 0;
        to_light *= random_number(0.1, 10);
        if (fabs(cosine) > 0.01 && vec3_dot(normal, to_eye) > 0.01)
            expect_halfway(ks, shine, light, normal, to_light, random_number(0.1, 10) * to_eye,
                           share * light);
    }
}
END_TEST

void list_tests_of_halfway(void)
{
    tests_of("halfway_term");
    test(where_the_normal_is_half_way_ks_of_the_light_is_seen);
    test(the_cosine_with_the_normal_is_taken_to_the_power_of_shine);
    test(shine_need_not_be_a_whole_number_here_either);
    test(only_the_directions_of_light_and_eye_matter);
    test(this_highlight_too_has_the_colour_of_the_light);
    test(half_way_below_the_surface_there_is_no_highlight);
    test(from_behind_the_surface_comes_no_highlight);
    test(half_way_at_an_angle_that_was_chosen);
    list_more_of_halfway_term();
}
