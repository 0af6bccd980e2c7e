// 07-shading-phong.c - tests of Phong's highlight.
#include "tests/07-shading.h"

void expect_phong(double ks, double shine, Color light, vec3 normal, vec3 to_light, vec3 to_eye,
                  Color color)
{
    given_highlight(ks, shine, light, normal, to_light, to_eye);
    expect_vec3(phong_term(ks, shine, light, normal, to_light, to_eye), color,
                TOLERANCE * largest(light));
}

static const vec3 up = {0, 1, 0};

// All of a white light, over a surface that lies flat.
static void expect_share(double shine, vec3 to_light, vec3 to_eye, double share)
{
    expect_phong(1, shine, vec3_of(1, 1, 1), up, to_light, to_eye, share * vec3_of(1, 1, 1));
}

START_TEST(who_looks_where_the_light_is_mirrored_to_sees_ks_of_the_light)
{
    Color light = vec3_of(0.9, 0.7, 0.8);
    for (int shine = 1; shine < 100; shine *= 3) {
        expect_phong(0.5, shine, light, up, vec3_of(0, 1, 0), vec3_of(0, 1, 0), light / 2);
        expect_phong(0.5, shine, light, up, vec3_of(4, 3, 0), vec3_of(-4, 3, 0), light / 2);
        expect_phong(0.5, shine, light, vec3_of(1, 0, 0), vec3_of(1, 2, 2), vec3_of(1, -2, -2),
                     light / 2);
    }
}
END_TEST

// From straight above the light is mirrored straight up; the cosine of (3, 4) with that is 4 / 5.
START_TEST(the_cosine_with_the_mirrored_light_is_taken_to_the_power_of_shine)
{
    expect_share(1, vec3_of(0, 1, 0), vec3_of(0.6, 0.8, 0), 0.8);
    expect_share(2, vec3_of(0, 1, 0), vec3_of(0.6, 0.8, 0), 0.64);
    expect_share(3, vec3_of(0, 1, 0), vec3_of(0, 0.8, -0.6), 0.512);
    expect_share(4, vec3_of(0, 1, 0), vec3_of(0.8, 0.6, 0), 0.1296);
}
END_TEST

// (4, 3, 0) is mirrored to (-4, 3, 0); its cosine with (0, 3, 4) is 9 / 25.
START_TEST(shine_need_not_be_a_whole_number)
{
    expect_share(0.5, vec3_of(0.8, 0.6, 0), vec3_of(0, 0.6, 0.8), 0.6);
    expect_share(1.5, vec3_of(0.8, 0.6, 0), vec3_of(0, 0.6, 0.8), 0.216);
    expect_share(2.5, vec3_of(0.8, 0.6, 0), vec3_of(0, 0.6, 0.8), 0.07776);
}
END_TEST

START_TEST(how_far_light_and_eye_are_does_not_matter)
{
    double length[] = {5, 10, 500, 0.05};
    for (int i = 0; i < 4; i++) {
        expect_share(1.5, length[i] * vec3_of(0.8, 0.6, 0), vec3_of(0, 0.6, 0.8), 0.216);
        expect_share(1.5, vec3_of(0.8, 0.6, 0), length[i] * vec3_of(0, 0.6, 0.8), 0.216);
    }
}
END_TEST

START_TEST(a_highlight_has_the_colour_of_the_light)
{
    expect_phong(0.5, 2, vec3_of(1, 0.5, 0), up, vec3_of(0, 1, 0), vec3_of(3, 4, 0),
                 vec3_of(0.32, 0.16, 0));
    expect_phong(0.25, 1, vec3_of(8, 12, 0.2), up, vec3_of(0, 1, 0), vec3_of(4, 3, 0),
                 vec3_of(1.2, 1.8, 0.03));
}
END_TEST

// Above the surface, but more than 90 degrees from the mirrored light, (-4, 3, 0): there the cosine
// is negative, its square is not.
START_TEST(far_from_the_mirrored_light_there_is_no_highlight)
{
    for (int shine = 1; shine <= 4; shine++) {
        expect_share(shine, vec3_of(4, 3, 0), vec3_of(4, 3, 0), 0);
        expect_share(shine, vec3_of(4, 3, 0), vec3_of(12, 3, 4), 0);
    }
    expect_share(2.5, vec3_of(4, 3, 0), vec3_of(12, 3, 4), 0);
}
END_TEST

// Mirrored all the same, (4, -3, 0) would go to (-4, -3, 0); the cosine of (-4, 1, 0) with that is
// positive.
START_TEST(a_light_behind_the_surface_makes_no_highlight)
{
    expect_share(2, vec3_of(4, -3, 0), vec3_of(-4, -3, 0), 0);
    expect_share(2, vec3_of(4, -3, 0), vec3_of(-4, 1, 0), 0);
    expect_share(7, vec3_of(4, -3, 0), vec3_of(-12, 3, 4), 0);
    expect_share(2, vec3_of(0, -1, 0), vec3_of(0, 1, 0), 0);
}
END_TEST

// The light and its mirrored way are as far from the normal, on either side of it, and the eye is
// at a chosen angle from the latter, above the surface.
START_TEST(at_an_angle_from_the_mirrored_light_that_was_chosen)
{
    for (int i = 0; i < 40; i++) {
        vec3 normal = random_unit(), across = random_across(normal);
        double low = random_number(5, 85), off = random_number(0, 150);
        vec3 to_light = turned(normal, low, across), mirrored = turned(normal, -low, across);
        vec3 to_eye = turned(mirrored, off, random_across(mirrored));
        double ks = random_number(0.1, 1), shine = random_number(0.5, 9);
        Color light = random_color(0.2, 2);
        double share = off < 90 ? ks * pow(cos(off * PI / 180), shine) : 0;
        to_light *= random_number(0.1, 10);
        if (vec3_dot(normal, to_eye) > 0.01)
            expect_phong(ks, shine, light, normal, to_light, random_number(0.1, 10) * to_eye,
                         share * light);
    }
}
END_TEST

void list_tests_of_phong(void)
{
    tests_of("phong_term");
    test(who_looks_where_the_light_is_mirrored_to_sees_ks_of_the_light);
    test(the_cosine_with_the_mirrored_light_is_taken_to_the_power_of_shine);
    test(shine_need_not_be_a_whole_number);
    test(how_far_light_and_eye_are_does_not_matter);
    test(a_highlight_has_the_colour_of_the_light);
    test(far_from_the_mirrored_light_there_is_no_highlight);
    test(a_light_behind_the_surface_makes_no_highlight);
    test(at_an_angle_from_the_mirrored_light_that_was_chosen);
    list_more_of_phong_term();
}
