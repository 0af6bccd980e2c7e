// 07-shading-scale.c - tests of light of any strength, from any distance and angle: nothing is too
// weak, too low, too far or too bright to count.
//
// Ladders: whoever has a limit fails at the rung behind it, and is known by that.
#include "tests/07-shading.h"

// 0.3, 0.03 ... 3e-8: what can still be told from 0 by the tolerance of a colour.
enum { SMALL = 8 };

static double small(int i)
{
    return 3 * pow(10, -1 - i);
}

// Sizes of worlds and strengths of light: 1, 0.001 ... 1e-12, then 1000 ... 1e12.
enum { SIZES = 9 };

static double size_number(int i)
{
    return pow(10, i < 5 ? -3 * i : 3 * (i - 4)) * random_number(0.5, 2);
}

static const vec3 up = {0, 1, 0}, white = {1, 1, 1};

// ---- the ways of light --------------------------------------------------------------------------

START_TEST(a_normal_is_unit_in_worlds_of_any_size)
{
    for (int i = 0; i < SIZES; i++) {
        double size = size_number(i);
        vec3 center = 3 * size * random_unit(), normal = random_unit();
        expect_normal((Sphere){.center = center, .radius = size}, center + size * normal, normal);
    }
}
END_TEST

START_TEST(the_way_to_a_light_is_as_long_as_it_is_in_worlds_of_any_size)
{
    for (int i = 0; i < SIZES; i++) {
        double size = size_number(i);
        vec3 from = size * random_vec3(-9, 9), way = size * random_number(0.5, 9) * random_unit();
        Light light = {from + way, {0.9, 0.7, 0.8}, LIGHT_POINT};
        expect_ray_to_light(from, light, way);
        light = (Light){way, {0.9, 0.7, 0.8}, LIGHT_DISTANT};
        expect_ray_to_light(from, light, way);
    }
}
END_TEST

START_TEST(directions_of_any_length_are_mirrored)
{
    for (int i = 0; i < SIZES; i++) {
        vec3 normal = random_unit(), across = size_number(i) * random_across(normal);
        vec3 along = random_number(0.5, 2) * vec3_length(across) * normal;
        expect_mirrored(across - along, normal, across + along);
    }
}
END_TEST

START_TEST(what_grazes_a_mirror_is_mirrored_too)
{
    for (int i = 0; i < SMALL; i++) {
        expect_mirrored(vec3_of(1, -small(i), 0), up, vec3_of(1, small(i), 0));
        expect_mirrored(vec3_of(0, small(i), -1), up, vec3_of(0, -small(i), -1));
    }
}
END_TEST

// ---- strength -----------------------------------------------------------------------------------

static const Color light_color = {0.9, 0.5, 0.7}, surface_color = {0.8, 0.3, 0.6};

START_TEST(ambient_light_may_be_of_any_strength)
{
    for (int i = 0; i < SIZES; i++) {
        double strength = size_number(i);
        expect_ambient(surface_color, 0.5, strength * light_color,
                       strength * vec3_of(0.36, 0.075, 0.21));
    }
}
END_TEST

START_TEST(a_light_may_be_of_any_strength)
{
    for (int i = 0; i < SIZES; i++) {
        double strength = size_number(i);
        expect_diffuse(surface_color, 0.5, strength * light_color, up, vec3_of(0.6, 0.8, 0),
                       strength * vec3_of(0.288, 0.06, 0.168));
    }
}
END_TEST

START_TEST(a_highlight_is_as_strong_as_its_light)
{
    for (int i = 0; i < SIZES; i++) {
        Color light = size_number(i) * light_color;
        expect_phong(0.5, 2, light, up, vec3_of(0, 1, 0), vec3_of(0.6, 0.8, 0), 0.32 * light);
    }
}
END_TEST

START_TEST(this_highlight_too_is_as_strong_as_its_light)
{
    for (int i = 0; i < SIZES; i++) {
        Color light = size_number(i) * light_color;
        expect_halfway(0.5, 2, light, up, vec3_of(0, 1, 0), vec3_of(0.96, 0.28, 0), 0.32 * light);
    }
}
END_TEST

START_TEST(a_dark_surface_sends_back_little_of_the_ambient_light)
{
    for (int i = 0; i < SMALL; i++) {
        expect_ambient(small(i) * surface_color, 1, white, small(i) * surface_color);
        expect_ambient(surface_color, small(i), white, small(i) * surface_color);
    }
}
END_TEST

START_TEST(a_dark_surface_scatters_little)
{
    for (int i = 0; i < SMALL; i++) {
        expect_diffuse(small(i) * surface_color, 1, white, up, up, small(i) * surface_color);
        expect_diffuse(surface_color, small(i), white, up, up, small(i) * surface_color);
    }
}
END_TEST

START_TEST(a_surface_that_hardly_shines_has_a_weak_highlight)
{
    for (int i = 0; i < SMALL; i++)
        expect_phong(small(i), 2, white, up, up, up, small(i) * white);
}
END_TEST

START_TEST(a_surface_that_hardly_shines_has_a_weak_highlight_here_too)
{
    for (int i = 0; i < SMALL; i++)
        expect_halfway(small(i), 2, white, up, up, up, small(i) * white);
}
END_TEST

// ---- how far ------------------------------------------------------------------------------------

START_TEST(a_light_may_be_as_near_or_as_far_as_it_likes)
{
    for (int i = 0; i < SIZES; i++)
        expect_diffuse(surface_color, 0.5, light_color, up, size_number(i) * vec3_of(0.6, 0.8, 0),
                       vec3_of(0.288, 0.06, 0.168));
}
END_TEST

START_TEST(light_and_eye_may_be_as_near_or_as_far_as_they_like)
{
    for (int i = 0; i < 2 * SIZES; i++) {
        double to_light = i < SIZES ? size_number(i) : 1;
        double to_eye = i < SIZES ? 1 : size_number(i - SIZES);
        expect_phong(0.5, 2, light_color, up, to_light * up, to_eye * vec3_of(0.6, 0.8, 0),
                     0.32 * light_color);
    }
}
END_TEST

START_TEST(here_too_light_and_eye_may_be_as_near_or_as_far_as_they_like)
{
    for (int i = 0; i < 2 * SIZES; i++) {
        double to_light = i < SIZES ? size_number(i) : 1;
        double to_eye = i < SIZES ? 1 : size_number(i - SIZES);
        expect_halfway(0.5, 2, light_color, up, to_light * up, to_eye * vec3_of(0.96, 0.28, 0),
                       0.32 * light_color);
    }
}
END_TEST

// ---- which angle --------------------------------------------------------------------------------

START_TEST(a_light_however_low_still_scatters)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = small(i) / hypot(1, small(i));
        expect_diffuse(white, 1, white, up, vec3_of(1, small(i), 0), cosine * white);
    }
}
END_TEST

START_TEST(a_light_nearly_straight_above_scatters_nearly_all)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = 1 - small(i), aside = sqrt((1 - cosine) * (1 + cosine));
        expect_diffuse(white, 1, white, up, vec3_of(0, cosine, aside), cosine * white);
    }
}
END_TEST

// The light is a little above the surface; mirrored, (-1, e, 0). The eye is at 45 degrees.
START_TEST(a_light_however_low_has_its_highlight)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = cos(PI / 4 - atan(small(i)));
        expect_phong(1, 2, white, up, vec3_of(1, small(i), 0), vec3_of(-1, 1, 0),
                     cosine * cosine * white);
    }
}
END_TEST

// Half-way between it and the eye is half of the angle between them from the eye.
START_TEST(a_light_however_low_has_its_highlight_here_too)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = cos((PI / 4 - atan(small(i))) / 2);
        expect_halfway(1, 2, white, up, vec3_of(1, small(i), 0), vec3_of(-1, 1, 0),
                       cosine * cosine * white);
    }
}
END_TEST

START_TEST(a_cosine_however_small_has_its_power)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = small(i) / hypot(1, small(i));
        expect_phong(1, 1, white, up, up, vec3_of(1, small(i), 0), cosine * white);
        expect_phong(1, 0.5, white, up, up, vec3_of(0, small(i), 1), sqrt(cosine) * white);
    }
}
END_TEST

// Light and eye in the same direction: that is half-way, too.
START_TEST(a_cosine_however_small_has_its_power_here_too)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = small(i) / hypot(1, small(i));
        vec3 there = vec3_of(1, small(i), 0);
        expect_halfway(1, 1, white, up, there, there, cosine * white);
        expect_halfway(1, 0.5, white, up, there, 2 * there, sqrt(cosine) * white);
    }
}
END_TEST

// ---- shine --------------------------------------------------------------------------------------

// From the dullest to the most polished: where half of ks of the light is seen.
static const double shines[] = {0.25, 0.75, 1,   3,   10,  11,  20,   33,
                                64,   100,  101, 128, 129, 300, 1001, 1e4};
enum { SHINES = sizeof shines / sizeof *shines };

static vec3 half_seen(double shine)
{
    double cosine = pow(0.5, 1 / shine);
    return vec3_of(sqrt((1 - cosine) * (1 + cosine)), cosine, 0);
}

START_TEST(shine_may_be_as_large_or_as_small_as_it_likes)
{
    for (int i = 0; i < SHINES; i++)
        expect_phong(1, shines[i], white, up, up, half_seen(shines[i]), 0.5 * white);
    expect_phong(0.5, 0, light_color, up, up, vec3_of(0.6, 0.8, 0), 0.5 * light_color);
}
END_TEST

START_TEST(here_too_shine_may_be_as_large_or_as_small_as_it_likes)
{
    for (int i = 0; i < SHINES; i++) {
        vec3 there = half_seen(shines[i]);
        expect_halfway(1, shines[i], white, up, there, 3 * there, 0.5 * white);
    }
    expect_halfway(0.5, 0, light_color, up, up, vec3_of(0.96, 0.28, 0), 0.5 * light_color);
}
END_TEST

// cos 60 degrees is 1 / 2, whose powers are exact.
START_TEST(a_high_power_leaves_little)
{
    const vec3 there = {0, 0.5, 0.86602540378443864676};
    for (int shine = 1; shine <= 24; shine++)
        expect_phong(1, shine, white, up, up, there, ldexp(1, -shine) * white);
}
END_TEST

START_TEST(a_high_power_leaves_little_here_too)
{
    const vec3 there = {0, 0.5, 0.86602540378443864676};
    for (int shine = 1; shine <= 24; shine++)
        expect_halfway(1, shine, white, up, there, there, ldexp(1, -shine) * white);
}
END_TEST

// ---- for a display ------------------------------------------------------------------------------

START_TEST(what_just_fits_stays_and_what_just_does_not_is_clamped)
{
    for (int i = 0; i < SMALL; i++) {
        double e = small(i);
        expect_clamped(vec3_of(e, 0.5, 1 - e), vec3_of(e, 0.5, 1 - e));
        expect_clamped(vec3_of(1 - e, e, 0.5), vec3_of(1 - e, e, 0.5));
        expect_clamped(vec3_of(-e, 0.5, 1 + e), vec3_of(0, 0.5, 1));
        expect_clamped(vec3_of(0.5, 1 + e, -e), vec3_of(0.5, 1, 0));
    }
}
END_TEST

START_TEST(however_bright_it_is_it_becomes_1)
{
    for (int i = 0; i < 13; i++) {
        double bright = 3 * pow(10, i);
        expect_clamped(vec3_of(bright, 0.25, 0.75), vec3_of(1, 0.25, 0.75));
        expect_clamped(vec3_of(0.75, -bright, bright), vec3_of(0.75, 0, 1));
        expect_clamped(vec3_of(bright, bright, 2 * bright), vec3_of(1, 1, 1));
    }
}
END_TEST

// With another program, as above: 0.4 to the power of 1 / gamma.
START_TEST(any_gamma_is_taken_as_it_is)
{
    for (int i = 0; i < 12; i++) {
        const double gammas[] = {1.001, 0.95, 1.05, 2.05, 2.15, 2.3, 2.5, 3.5, 7, 25, 0.3, 0.06};
        Color encoded = vec3_of(0.5, 0.8, 0.65);
        double gamma = gammas[i];
        expect_encoded(vec3_of(pow(0.5, gamma), pow(0.8, gamma), pow(0.65, gamma)), gamma, encoded);
    }
}
END_TEST

START_TEST(however_dark_it_is_it_is_encoded)
{
    for (int i = 0; i < SMALL; i++) {
        double e = small(i);
        expect_encoded(vec3_of(e, 0.5, 1), 1, vec3_of(e, 0.5, 1));
        expect_encoded(vec3_of(0.25, e * e, 1), 2, vec3_of(0.5, e, 1));
        expect_encoded(vec3_of(1, 0.125, e * e * e), 3, vec3_of(1, 0.5, e));
    }
}
END_TEST

void list_more_of_surface_normal(void)
{
    test(a_normal_is_unit_in_worlds_of_any_size);
}

void list_more_of_ray_to_light(void)
{
    test(the_way_to_a_light_is_as_long_as_it_is_in_worlds_of_any_size);
}

void list_more_of_mirror_direction(void)
{
    test(directions_of_any_length_are_mirrored);
    test(what_grazes_a_mirror_is_mirrored_too);
}

void list_more_of_ambient_term(void)
{
    test(ambient_light_may_be_of_any_strength);
    test(a_dark_surface_sends_back_little_of_the_ambient_light);
}

void list_more_of_diffuse_term(void)
{
    test(a_light_may_be_of_any_strength);
    test(a_dark_surface_scatters_little);
    test(a_light_may_be_as_near_or_as_far_as_it_likes);
    test(a_light_however_low_still_scatters);
    test(a_light_nearly_straight_above_scatters_nearly_all);
}

void list_more_of_phong_term(void)
{
    test(a_highlight_is_as_strong_as_its_light);
    test(a_surface_that_hardly_shines_has_a_weak_highlight);
    test(light_and_eye_may_be_as_near_or_as_far_as_they_like);
    test(a_light_however_low_has_its_highlight);
    test(a_cosine_however_small_has_its_power);
    test(shine_may_be_as_large_or_as_small_as_it_likes);
    test(a_high_power_leaves_little);
}

void list_more_of_halfway_term(void)
{
    test(this_highlight_too_is_as_strong_as_its_light);
    test(a_surface_that_hardly_shines_has_a_weak_highlight_here_too);
    test(here_too_light_and_eye_may_be_as_near_or_as_far_as_they_like);
    test(a_light_however_low_has_its_highlight_here_too);
    test(a_cosine_however_small_has_its_power_here_too);
    test(here_too_shine_may_be_as_large_or_as_small_as_it_likes);
    test(a_high_power_leaves_little_here_too);
}

void list_more_of_clamp_color(void)
{
    test(what_just_fits_stays_and_what_just_does_not_is_clamped);
    test(however_bright_it_is_it_becomes_1);
}

void list_more_of_gamma_encode(void)
{
    test(any_gamma_is_taken_as_it_is);
    test(however_dark_it_is_it_is_encoded);
}
