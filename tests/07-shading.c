// 07-shading.c - tests of exercise 07. Expected values: terms worked out by hand with cosines that
// are short numbers, and vectors that were constructed from the angles that they must have.
#include "tests/07-shading/support.h"

#include "tests/07-shading/support-scene.h"

// ---- surface_normal -----------------------------------------------------------------------------

static void expect_normal(Sphere sphere, vec3 point, vec3 normal)
{
    given_sphere(sphere);
    given_vec3("point", point);
    expect_vec3(surface_normal(sphere, point), normal, TOLERANCE);
}

START_TEST(at_the_top_of_a_sphere_the_normal_points_up)
{
    expect_normal(sphere_at(0, 0, 0, 1), vec3_of(0, 1, 0), vec3_of(0, 1, 0));
    expect_normal(sphere_at(1, 2, -3, 1), vec3_of(1, 3, -3), vec3_of(0, 1, 0));
    expect_normal(sphere_at(1, 2, -3, 4), vec3_of(1, 6, -3), vec3_of(0, 1, 0));
}
END_TEST

START_TEST(on_opposite_sides_the_normals_are_opposite)
{
    expect_normal(sphere_at(5, 0, -7, 2), vec3_of(7, 0, -7), vec3_of(1, 0, 0));
    expect_normal(sphere_at(5, 0, -7, 2), vec3_of(3, 0, -7), vec3_of(-1, 0, 0));
}
END_TEST

// (2, 3, 6) is 7 long.
START_TEST(a_normal_is_unit_however_large_the_sphere_is)
{
    vec3 normal = vec3_of(2, 3, 6) / 7;
    expect_normal(sphere_at(4, -1, 2, 7), vec3_of(6, 2, 8), normal);
    expect_normal(sphere_at(4, -1, 2, 700), vec3_of(204, 299, 602), normal);
    expect_normal(sphere_at(4, -1, 2, 0.07), vec3_of(4.02, -0.97, 2.06), normal);
}
END_TEST

START_TEST(a_chosen_normal_is_found_again)
{
    for (int i = 0; i < 20; i++) {
        Sphere sphere = random_sphere(9, 0.1, 5);
        vec3 normal = random_unit();
        expect_normal(sphere, sphere.center + sphere.radius * normal, normal);
    }
}
END_TEST

// ---- ray_to_light -------------------------------------------------------------------------------

static void expect_ray_to_light(vec3 from, Light light, vec3 direction)
{
    Ray ray = ray_to_light(from, light);
    double tolerance = TOLERANCE * fmax(largest(from), largest(light.position));
    given_vec3("from", from);
    given_light(light);
    given("looking at", "the origin");
    expect_vec3(ray.origin, from, tolerance);
    given_vec3("from", from);
    given_light(light);
    given("looking at", "the direction");
    expect_vec3(ray.direction, direction, tolerance);
}

static Light light_of(LightKind kind, vec3 position)
{
    return (Light){position, {0.9, 0.7, 0.8}, kind};
}

START_TEST(a_point_light_is_at_t_1)
{
    Light light = light_of(LIGHT_POINT, vec3_of(4, 6, 3));
    expect_ray_to_light(vec3_of(1, 2, 3), light, vec3_of(3, 4, 0));
    expect_ray_to_light(vec3_of(0, 0, 0), light, vec3_of(4, 6, 3));
    expect_ray_to_light(vec3_of(5, 6, -4), light, vec3_of(-1, 0, 7));
}
END_TEST

START_TEST(a_distant_light_has_one_direction_from_everywhere)
{
    Light light = light_of(LIGHT_DISTANT, vec3_of(1, 3, -2));
    expect_ray_to_light(vec3_of(1, 2, 3), light, vec3_of(1, 3, -2));
    expect_ray_to_light(vec3_of(-50, 4, 70), light, vec3_of(1, 3, -2));
    expect_ray_to_light(vec3_of(0, 0, 0), light, vec3_of(1, 3, -2));
}
END_TEST

START_TEST(the_ray_reaches_a_light_at_a_chosen_place)
{
    for (int i = 0; i < 20; i++) {
        vec3 from = random_vec3(-9, 9), way = random_unit();
        way *= random_number(0.5, 9);
        expect_ray_to_light(from, light_of(LIGHT_POINT, from + way), way);
        expect_ray_to_light(from, light_of(LIGHT_DISTANT, way), way);
    }
}
END_TEST

// ---- mirror_direction ---------------------------------------------------------------------------

static void expect_mirrored(vec3 direction, vec3 normal, vec3 mirrored)
{
    given_vec3("direction", direction);
    given_vec3("normal", normal);
    expect_vec3(mirror_direction(direction, normal), mirrored, TOLERANCE * vec3_length(direction));
}

static const vec3 up = {0, 1, 0};

START_TEST(a_ray_along_the_normal_comes_straight_back)
{
    expect_mirrored(vec3_of(0, -1, 0), up, vec3_of(0, 1, 0));
    expect_mirrored(vec3_of(-2, -3, -6), vec3_of(2, 3, 6) / 7, vec3_of(2, 3, 6));
}
END_TEST

START_TEST(a_ray_that_comes_down_at_an_angle_goes_on_and_up)
{
    expect_mirrored(vec3_of(1, -1, 0), up, vec3_of(1, 1, 0));
    expect_mirrored(vec3_of(3, -4, 12), up, vec3_of(3, 4, 12));
    expect_mirrored(vec3_of(3, -4, 12), vec3_of(-1, 0, 0), vec3_of(-3, -4, 12));
}
END_TEST

START_TEST(a_ray_along_the_mirror_goes_on_unchanged)
{
    expect_mirrored(vec3_of(2, 0, 1), up, vec3_of(2, 0, 1));
}
END_TEST

// By hand: (3, 3, -3) goes 3 along (2, 2, 1) / 3, so twice that, (4, 4, 2), is subtracted.
START_TEST(a_mirror_at_an_angle)
{
    expect_mirrored(vec3_of(3, 3, -3), vec3_of(-2, -2, -1) / 3, vec3_of(-1, -1, -5));
    expect_mirrored(vec3_of(1, 1, 5), vec3_of(-2, -2, -1) / 3, vec3_of(-3, -3, 3));
}
END_TEST

START_TEST(a_mirror_has_two_sides)
{
    expect_mirrored(vec3_of(1, 1, 0), up, vec3_of(1, -1, 0));
    expect_mirrored(vec3_of(3, 3, -3), vec3_of(2, 2, 1) / 3, vec3_of(-1, -1, -5));
}
END_TEST

START_TEST(the_part_along_the_normal_is_reversed_and_the_part_across_it_stays)
{
    for (int i = 0; i < 20; i++) {
        vec3 normal = random_unit(), across = random_across(normal);
        vec3 along = random_number(-5, 5) * normal;
        across *= random_number(0.5, 5);
        expect_mirrored(along + across, normal, across - along);
    }
}
END_TEST

// ---- ambient_term -------------------------------------------------------------------------------

static void expect_ambient(Color surface, double kd, Color ambient, Color color)
{
    given_color("surface", surface);
    given_number("kd", kd);
    given_color("ambient", ambient);
    expect_vec3(ambient_term(surface, kd, ambient), color, TOLERANCE * largest(ambient));
}

START_TEST(in_white_ambient_light_kd_of_the_surface_is_seen)
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

START_TEST(without_ambient_light_the_term_is_black)
{
    expect_ambient(vec3_of(0.8, 0.5, 0.2), 0.5, vec3_of(0, 0, 0), vec3_of(0, 0, 0));
}
END_TEST

START_TEST(strong_ambient_light_may_be_brighter_than_white)
{
    expect_ambient(vec3_of(0.9, 0.5, 0.1), 1, vec3_of(4, 3, 2), vec3_of(3.6, 1.5, 0.2));
}
END_TEST

// The result is chosen, and the ambient light made to fit.
START_TEST(a_chosen_ambient_term_is_found_again)
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

static void expect_diffuse(Color surface, double kd, Color light, vec3 normal, vec3 to_light,
                           Color color)
{
    given_color("surface", surface);
    given_number("kd", kd);
    given_color("light", light);
    given_vec3("normal", normal);
    given_vec3("to light", to_light);
    expect_vec3(diffuse_term(surface, kd, light, normal, to_light), color,
                TOLERANCE * largest(light));
}

// A surface that reflects all of a white light: the result is the share that arrives.
static void expect_diffuse_share(vec3 to_light, double share)
{
    expect_diffuse(vec3_of(1, 1, 1), 1, vec3_of(1, 1, 1), up, to_light, share * vec3_of(1, 1, 1));
}

START_TEST(light_from_straight_above_is_scattered_in_full)
{
    expect_diffuse_share(vec3_of(0, 1, 0), 1);
    expect_diffuse_share(vec3_of(0, 7, 0), 1);
}
END_TEST

// 3, 4, 5: the cosine is 4 / 5 if the light is high, and 3 / 5 if it is low.
START_TEST(the_lower_the_light_the_less_is_scattered)
{
    expect_diffuse_share(vec3_of(0.6, 0.8, 0), 0.8);
    expect_diffuse_share(vec3_of(0, 0.6, -0.8), 0.6);
    expect_diffuse_share(vec3_of(-0.96, 0.28, 0), 0.28);
    expect_diffuse_share(vec3_of(1, 0, 0), 0);
}
END_TEST

START_TEST(a_light_twice_as_far_in_the_same_direction_scatters_as_much)
{
    double length[] = {5, 10, 500, 0.05};
    for (int i = 0; i < 4; i++)
        expect_diffuse_share(length[i] * vec3_of(0.6, 0.8, 0), 0.8);
}
END_TEST

START_TEST(a_light_behind_the_surface_scatters_nothing)
{
    expect_diffuse_share(vec3_of(0, -1, 0), 0);
    expect_diffuse_share(vec3_of(6, -8, 0), 0);
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

START_TEST(at_a_chosen_angle_its_cosine_is_scattered)
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

// ---- phong_term: Phong's highlight -------------------------------------------------------------

static void expect_phong(double ks, double shine, Color light, vec3 normal, vec3 to_light,
                         vec3 to_eye, Color color)
{
    given_highlight(ks, shine, light, normal, to_light, to_eye);
    expect_vec3(phong_term(ks, shine, light, normal, to_light, to_eye), color,
                TOLERANCE * largest(light));
}

// All of a white light, over a horizontal surface.
static void expect_phong_share(double shine, vec3 to_light, vec3 to_eye, double share)
{
    expect_phong(1, shine, vec3_of(1, 1, 1), up, to_light, to_eye, share * vec3_of(1, 1, 1));
}

START_TEST(an_eye_in_the_mirrored_direction_sees_ks_of_the_light)
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
START_TEST(the_cosine_with_the_mirrored_light_is_raised_to_the_power_of_shine)
{
    expect_phong_share(1, vec3_of(0, 1, 0), vec3_of(0.6, 0.8, 0), 0.8);
    expect_phong_share(2, vec3_of(0, 1, 0), vec3_of(0.6, 0.8, 0), 0.64);
    expect_phong_share(3, vec3_of(0, 1, 0), vec3_of(0, 0.8, -0.6), 0.512);
    expect_phong_share(4, vec3_of(0, 1, 0), vec3_of(0.8, 0.6, 0), 0.1296);
}
END_TEST

// (4, 3, 0) is mirrored to (-4, 3, 0); its cosine with (0, 3, 4) is 9 / 25.
START_TEST(shine_need_not_be_a_whole_number)
{
    expect_phong_share(0.5, vec3_of(0.8, 0.6, 0), vec3_of(0, 0.6, 0.8), 0.6);
    expect_phong_share(1.5, vec3_of(0.8, 0.6, 0), vec3_of(0, 0.6, 0.8), 0.216);
    expect_phong_share(2.5, vec3_of(0.8, 0.6, 0), vec3_of(0, 0.6, 0.8), 0.07776);
}
END_TEST

START_TEST(how_far_light_and_eye_are_does_not_matter)
{
    double length[] = {5, 10, 500, 0.05};
    for (int i = 0; i < 4; i++) {
        expect_phong_share(1.5, length[i] * vec3_of(0.8, 0.6, 0), vec3_of(0, 0.6, 0.8), 0.216);
        expect_phong_share(1.5, vec3_of(0.8, 0.6, 0), length[i] * vec3_of(0, 0.6, 0.8), 0.216);
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
        expect_phong_share(shine, vec3_of(4, 3, 0), vec3_of(4, 3, 0), 0);
        expect_phong_share(shine, vec3_of(4, 3, 0), vec3_of(12, 3, 4), 0);
    }
    expect_phong_share(2.5, vec3_of(4, 3, 0), vec3_of(12, 3, 4), 0);
}
END_TEST

// If it were mirrored nevertheless, (4, -3, 0) would go to (-4, -3, 0); the cosine of (-4, 1, 0)
// with that is positive.
START_TEST(a_light_behind_the_surface_makes_no_highlight)
{
    expect_phong_share(2, vec3_of(4, -3, 0), vec3_of(-4, -3, 0), 0);
    expect_phong_share(2, vec3_of(4, -3, 0), vec3_of(-4, 1, 0), 0);
    expect_phong_share(7, vec3_of(4, -3, 0), vec3_of(-12, 3, 4), 0);
    expect_phong_share(2, vec3_of(0, -1, 0), vec3_of(0, 1, 0), 0);
    for (double length = 1; length > 1e-6; length /= 10)
        expect_phong_share(2, length * vec3_of(0.8, -0.6, 0), vec3_of(-4, 1, 0), 0);
}
END_TEST

// The light and its mirrored direction are equally far from the normal, on opposite sides, and the
// eye is at a chosen angle from the latter, above the surface.
START_TEST(at_a_chosen_angle_from_the_mirrored_light)
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

// ---- halfway_term: the highlight by the half-way vector, Blinn's -------------------------------

static void expect_halfway(double ks, double shine, Color light, vec3 normal, vec3 to_light,
                           vec3 to_eye, Color color)
{
    given_highlight(ks, shine, light, normal, to_light, to_eye);
    expect_vec3(halfway_term(ks, shine, light, normal, to_light, to_eye), color,
                TOLERANCE * largest(light));
}

// All of a white light, over a horizontal surface.
static void expect_halfway_share(double shine, vec3 to_light, vec3 to_eye, double share)
{
    expect_halfway(1, shine, vec3_of(1, 1, 1), up, to_light, to_eye, share * vec3_of(1, 1, 1));
}

START_TEST(if_the_normal_is_half_way_ks_of_the_light_is_seen)
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
START_TEST(the_cosine_with_the_normal_is_raised_to_the_power_of_shine)
{
    vec3 eye = vec3_of(0.96, 0.28, 0), eye_aside = vec3_of(0, 0.28, -0.96);
    expect_halfway_share(1, vec3_of(0, 1, 0), eye, 0.8);
    expect_halfway_share(2, vec3_of(0, 1, 0), eye, 0.64);
    expect_halfway_share(3, vec3_of(0, 1, 0), eye_aside, 0.512);
    expect_halfway_share(4, eye, vec3_of(0, 1, 0), 0.4096);
}
END_TEST

// Half-way between a direction and itself is that direction; the cosine of (12, 9, 20) / 25 with
// the normal is 9 / 25.
START_TEST(shine_need_not_be_a_whole_number_here_either)
{
    vec3 there = vec3_of(0.48, 0.36, 0.8);
    expect_halfway_share(0.5, there, there, 0.6);
    expect_halfway_share(1.5, there, there, 0.216);
    expect_halfway_share(2.5, there, there, 0.07776);
}
END_TEST

START_TEST(only_the_directions_of_light_and_eye_matter)
{
    double length[] = {5, 10, 500, 0.05};
    for (int i = 0; i < 4; i++) {
        expect_halfway_share(2, length[i] * vec3_of(0, 1, 0), vec3_of(0.96, 0.28, 0), 0.64);
        expect_halfway_share(2, vec3_of(0, 1, 0), length[i] * vec3_of(0.96, 0.28, 0), 0.64);
    }
}
END_TEST

START_TEST(this_highlight_also_has_the_colour_of_the_light)
{
    expect_halfway(0.5, 2, vec3_of(1, 0.5, 0), up, vec3_of(0, 1, 0), vec3_of(24, 7, 0),
                   vec3_of(0.32, 0.16, 0));
    expect_halfway(0.25, 1, vec3_of(8, 12, 0.2), up, vec3_of(0, 1, 0), vec3_of(24, 7, 0),
                   vec3_of(1.6, 2.4, 0.04));
}
END_TEST

// Half-way between (4, 3, 0) / 5 and the eye is below the surface: there the cosine is negative,
// its square is not.
START_TEST(if_half_way_is_below_the_surface_there_is_no_highlight)
{
    for (int shine = 1; shine <= 4; shine++) {
        expect_halfway_share(shine, vec3_of(4, 3, 0), vec3_of(0, -1, 0), 0);
        expect_halfway_share(shine, vec3_of(4, 3, 0), vec3_of(1, -4, 1), 0);
    }
    expect_halfway_share(2.5, vec3_of(4, 3, 0), vec3_of(1, -4, 1), 0);
}
END_TEST

START_TEST(a_light_behind_the_surface_has_no_highlight_here_either)
{
    expect_halfway_share(2, vec3_of(4, -3, 0), vec3_of(-4, -3, 0), 0);
    expect_halfway_share(2, vec3_of(4, -3, 0), vec3_of(0, 1, 0), 0);
    expect_halfway_share(7, vec3_of(12, -3, 4), vec3_of(-3, 5, 1), 0);
}
END_TEST

// The half-way vector is at a chosen angle from the normal; light and eye are equally far from it,
// on opposite sides.
START_TEST(half_way_at_a_chosen_angle)
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

// ---- clamp_color --------------------------------------------------------------------------------

static void expect_clamped(Color color, Color clamped)
{
    given_color("colour", color);
    expect_vec3(clamp_color(color), clamped, TOLERANCE);
}

START_TEST(a_number_between_0_and_1_stays)
{
    expect_clamped(vec3_of(0.25, 0.5, 0.125), vec3_of(0.25, 0.5, 0.125));
    expect_clamped(vec3_of(0, 1, 0.999), vec3_of(0, 1, 0.999));
}
END_TEST

START_TEST(a_number_above_1_becomes_1_and_the_others_stay)
{
    expect_clamped(vec3_of(0.5, 300, 0.25), vec3_of(0.5, 1, 0.25));
    expect_clamped(vec3_of(1.5, 0.5, 0.25), vec3_of(1, 0.5, 0.25));
    expect_clamped(vec3_of(0.5, 0.25, 2), vec3_of(0.5, 0.25, 1));
    expect_clamped(vec3_of(1.1, 2.2, 3.3), vec3_of(1, 1, 1));
}
END_TEST

START_TEST(a_number_below_0_becomes_0_and_the_others_stay)
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

static void expect_encoded(Color color, double gamma, Color encoded)
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

// The display squares its input, so a quarter of the light needs half; and so on.
START_TEST(a_gamma_of_2_needs_the_square_root_and_3_the_cube_root)
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

// From another program: 2.2nd roots.
START_TEST(a_gamma_of_2_2_as_of_most_displays)
{
    expect_encoded(vec3_of(0.2, 0.5, 0.8), 2.2,
                   vec3_of(0.4811565050522864, 0.7297400528407231, 0.9035454309190944));
}
END_TEST

START_TEST(the_display_shows_the_colour_that_was_meant)
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

// ---- light of any strength, from any distance and angle ----------------------------------------

// No light is too weak, too low, too far or too bright to count. Ladders: an answer with a limit
// fails at the first rung after it, and that rung names the limit.

// 0.3, 0.03 ... 3e-8: the smallest that the tolerance of a colour still distinguishes from 0.
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

static const vec3 white = {1, 1, 1};

// ---- directions of light ------------------------------------------------------------------------

START_TEST(a_normal_is_unit_in_worlds_of_any_size)
{
    for (int i = 0; i < SIZES; i++) {
        double size = size_number(i);
        vec3 center = 3 * size * random_unit(), normal = random_unit();
        expect_normal((Sphere){.center = center, .radius = size}, center + size * normal, normal);
    }
}
END_TEST

START_TEST(the_way_to_a_light_has_the_right_length_in_worlds_of_any_size)
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

START_TEST(a_ray_that_grazes_a_mirror_is_also_mirrored)
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

START_TEST(this_highlight_is_also_as_strong_as_its_light)
{
    for (int i = 0; i < SIZES; i++) {
        Color light = size_number(i) * light_color;
        expect_halfway(0.5, 2, light, up, vec3_of(0, 1, 0), vec3_of(0.96, 0.28, 0), 0.32 * light);
    }
}
END_TEST

START_TEST(a_dark_surface_reflects_little_of_the_ambient_light)
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

START_TEST(a_surface_that_hardly_shines_also_has_a_weak_highlight_here)
{
    for (int i = 0; i < SMALL; i++)
        expect_halfway(small(i), 2, white, up, up, up, small(i) * white);
}
END_TEST

// ---- distances ----------------------------------------------------------------------------------

START_TEST(a_light_may_be_at_any_distance)
{
    for (int i = 0; i < SIZES; i++)
        expect_diffuse(surface_color, 0.5, light_color, up, size_number(i) * vec3_of(0.6, 0.8, 0),
                       vec3_of(0.288, 0.06, 0.168));
}
END_TEST

START_TEST(light_and_eye_may_be_at_any_distance)
{
    for (int i = 0; i < 2 * SIZES; i++) {
        double to_light = i < SIZES ? size_number(i) : 1;
        double to_eye = i < SIZES ? 1 : size_number(i - SIZES);
        expect_phong(0.5, 2, light_color, up, to_light * up, to_eye * vec3_of(0.6, 0.8, 0),
                     0.32 * light_color);
    }
}
END_TEST

START_TEST(light_and_eye_may_be_at_any_distance_here_as_well)
{
    for (int i = 0; i < 2 * SIZES; i++) {
        double to_light = i < SIZES ? size_number(i) : 1;
        double to_eye = i < SIZES ? 1 : size_number(i - SIZES);
        expect_halfway(0.5, 2, light_color, up, to_light * up, to_eye * vec3_of(0.96, 0.28, 0),
                       0.32 * light_color);
    }
}
END_TEST

// ---- angles -------------------------------------------------------------------------------------

START_TEST(a_light_is_scattered_even_if_it_is_very_low)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = small(i) / hypot(1, small(i));
        expect_diffuse(white, 1, white, up, vec3_of(1, small(i), 0), cosine * white);
    }
}
END_TEST

START_TEST(a_light_almost_straight_above_is_scattered_almost_fully)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = 1 - small(i), aside = sqrt((1 - cosine) * (1 + cosine));
        expect_diffuse(white, 1, white, up, vec3_of(0, cosine, aside), cosine * white);
    }
}
END_TEST

// The light is a little above the surface; mirrored, (-1, e, 0). The eye is at 45 degrees.
START_TEST(a_light_has_its_highlight_even_if_it_is_very_low)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = cos(PI / 4 - atan(small(i)));
        expect_phong(1, 2, white, up, vec3_of(1, small(i), 0), vec3_of(-1, 1, 0),
                     cosine * cosine * white);
    }
}
END_TEST

// The half-way vector between it and the eye is at half the angle between them from the eye.
START_TEST(a_light_has_its_highlight_here_even_if_it_is_very_low)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = cos((PI / 4 - atan(small(i))) / 2);
        expect_halfway(1, 2, white, up, vec3_of(1, small(i), 0), vec3_of(-1, 1, 0),
                       cosine * cosine * white);
    }
}
END_TEST

START_TEST(a_cosine_has_its_power_even_if_it_is_very_small)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = small(i) / hypot(1, small(i));
        expect_phong(1, 1, white, up, up, vec3_of(1, small(i), 0), cosine * white);
        expect_phong(1, 0.5, white, up, up, vec3_of(0, small(i), 1), sqrt(cosine) * white);
    }
}
END_TEST

// Light and eye in the same direction: that is also the half-way vector.
START_TEST(a_cosine_has_its_power_here_even_if_it_is_very_small)
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

// From the dullest to the most polished: the angle at which half of ks of the light is seen.
static const double shines[] = {0.25, 0.75, 1,   3,   10,  11,  20,   33,
                                64,   100,  101, 128, 129, 300, 1001, 1e4};
enum { SHINES = sizeof shines / sizeof *shines };

static vec3 half_seen(double shine)
{
    double cosine = pow(0.5, 1 / shine);
    return vec3_of(sqrt((1 - cosine) * (1 + cosine)), cosine, 0);
}

START_TEST(shine_may_be_of_any_size)
{
    for (int i = 0; i < SHINES; i++)
        expect_phong(1, shines[i], white, up, up, half_seen(shines[i]), 0.5 * white);
    expect_phong(0.5, 0, light_color, up, up, vec3_of(0.6, 0.8, 0), 0.5 * light_color);
}
END_TEST

START_TEST(shine_may_be_of_any_size_here_as_well)
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

// The share that is seen at a small angle from the middle: with a high power that is not all of it.
static double near_the_middle(double angle)
{
    return pow(cos(angle), 50);
}

START_TEST(close_to_its_middle_a_highlight_is_already_weaker)
{
    for (double angle = 0.03; angle > 1e-5; angle /= 10)
        expect_phong(1, 50, white, up, up, vec3_of(sin(angle), cos(angle), 0),
                     near_the_middle(angle) * white);
}
END_TEST

START_TEST(close_to_its_middle_this_highlight_is_also_weaker)
{
    for (double angle = 0.03; angle > 1e-5; angle /= 10) {
        vec3 there = vec3_of(sin(angle), cos(angle), 0);
        expect_halfway(1, 50, white, up, there, there, near_the_middle(angle) * white);
    }
}
END_TEST

START_TEST(a_high_power_also_leaves_little_here)
{
    const vec3 there = {0, 0.5, 0.86602540378443864676};
    for (int shine = 1; shine <= 24; shine++)
        expect_halfway(1, shine, white, up, there, there, ldexp(1, -shine) * white);
}
END_TEST

// ---- for a display ------------------------------------------------------------------------------

START_TEST(a_number_that_just_fits_stays_and_one_that_just_does_not_is_clamped)
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

START_TEST(a_number_above_1_becomes_1_however_bright_it_is)
{
    for (int i = 0; i < 13; i++) {
        double bright = 3 * pow(10, i);
        expect_clamped(vec3_of(bright, 0.25, 0.75), vec3_of(1, 0.25, 0.75));
        expect_clamped(vec3_of(0.75, -bright, bright), vec3_of(0.75, 0, 1));
        expect_clamped(vec3_of(bright, bright, 2 * bright), vec3_of(1, 1, 1));
    }
}
END_TEST

// From another program, as above: 0.4 to the power of 1 / gamma.
START_TEST(any_gamma_is_used_unchanged)
{
    for (int i = 0; i < 12; i++) {
        const double gammas[] = {1.001, 0.95, 1.05, 2.05, 2.15, 2.3, 2.5, 3.5, 7, 25, 0.3, 0.06};
        Color encoded = vec3_of(0.5, 0.8, 0.65);
        double gamma = gammas[i];
        expect_encoded(vec3_of(pow(0.5, gamma), pow(0.8, gamma), pow(0.65, gamma)), gamma, encoded);
    }
}
END_TEST

START_TEST(a_colour_is_encoded_however_dark_it_is)
{
    for (int i = 0; i < SMALL; i++) {
        double e = small(i);
        expect_encoded(vec3_of(e, 0.5, 1), 1, vec3_of(e, 0.5, 1));
        expect_encoded(vec3_of(0.25, e * e, 1), 2, vec3_of(0.5, e, 1));
        expect_encoded(vec3_of(1, 0.125, e * e * e), 3, vec3_of(1, 0.5, e));
    }
}
END_TEST

static void list_tests(void)
{
    tests_of("surface_normal");
    test(at_the_top_of_a_sphere_the_normal_points_up);
    test(on_opposite_sides_the_normals_are_opposite);
    test(a_normal_is_unit_however_large_the_sphere_is);
    test(a_chosen_normal_is_found_again);
    test(a_normal_is_unit_in_worlds_of_any_size);

    tests_of("ray_to_light");
    test(a_point_light_is_at_t_1);
    test(a_distant_light_has_one_direction_from_everywhere);
    test(the_ray_reaches_a_light_at_a_chosen_place);
    test(the_way_to_a_light_has_the_right_length_in_worlds_of_any_size);

    tests_of("mirror_direction");
    test(a_ray_along_the_normal_comes_straight_back);
    test(a_ray_that_comes_down_at_an_angle_goes_on_and_up);
    test(a_ray_along_the_mirror_goes_on_unchanged);
    test(a_mirror_at_an_angle);
    test(a_mirror_has_two_sides);
    test(the_part_along_the_normal_is_reversed_and_the_part_across_it_stays);
    test(directions_of_any_length_are_mirrored);
    test(a_ray_that_grazes_a_mirror_is_also_mirrored);
    tests_of("ambient_term");
    test(in_white_ambient_light_kd_of_the_surface_is_seen);
    test(ambient_light_is_multiplied_colour_by_colour);
    test(without_ambient_light_the_term_is_black);
    test(strong_ambient_light_may_be_brighter_than_white);
    test(a_chosen_ambient_term_is_found_again);
    test(ambient_light_may_be_of_any_strength);
    test(a_dark_surface_reflects_little_of_the_ambient_light);

    tests_of("diffuse_term");
    test(light_from_straight_above_is_scattered_in_full);
    test(the_lower_the_light_the_less_is_scattered);
    test(a_light_twice_as_far_in_the_same_direction_scatters_as_much);
    test(a_light_behind_the_surface_scatters_nothing);
    test(light_is_multiplied_colour_by_colour);
    test(a_bright_light_may_be_scattered_brighter_than_white);
    test(at_a_chosen_angle_its_cosine_is_scattered);
    test(a_light_may_be_of_any_strength);
    test(a_dark_surface_scatters_little);
    test(a_light_may_be_at_any_distance);
    test(a_light_is_scattered_even_if_it_is_very_low);
    test(a_light_almost_straight_above_is_scattered_almost_fully);
    tests_of("phong_term");
    test(an_eye_in_the_mirrored_direction_sees_ks_of_the_light);
    test(the_cosine_with_the_mirrored_light_is_raised_to_the_power_of_shine);
    test(shine_need_not_be_a_whole_number);
    test(how_far_light_and_eye_are_does_not_matter);
    test(a_highlight_has_the_colour_of_the_light);
    test(far_from_the_mirrored_light_there_is_no_highlight);
    test(a_light_behind_the_surface_makes_no_highlight);
    test(at_a_chosen_angle_from_the_mirrored_light);
    test(a_highlight_is_as_strong_as_its_light);
    test(a_surface_that_hardly_shines_has_a_weak_highlight);
    test(light_and_eye_may_be_at_any_distance);
    test(a_light_has_its_highlight_even_if_it_is_very_low);
    test(a_cosine_has_its_power_even_if_it_is_very_small);
    test(shine_may_be_of_any_size);
    test(a_high_power_leaves_little);
    test(close_to_its_middle_a_highlight_is_already_weaker);
    tests_of("halfway_term");
    test(if_the_normal_is_half_way_ks_of_the_light_is_seen);
    test(the_cosine_with_the_normal_is_raised_to_the_power_of_shine);
    test(shine_need_not_be_a_whole_number_here_either);
    test(only_the_directions_of_light_and_eye_matter);
    test(this_highlight_also_has_the_colour_of_the_light);
    test(if_half_way_is_below_the_surface_there_is_no_highlight);
    test(a_light_behind_the_surface_has_no_highlight_here_either);
    test(half_way_at_a_chosen_angle);
    test(this_highlight_is_also_as_strong_as_its_light);
    test(a_surface_that_hardly_shines_also_has_a_weak_highlight_here);
    test(light_and_eye_may_be_at_any_distance_here_as_well);
    test(a_light_has_its_highlight_here_even_if_it_is_very_low);
    test(a_cosine_has_its_power_here_even_if_it_is_very_small);
    test(shine_may_be_of_any_size_here_as_well);
    test(a_high_power_also_leaves_little_here);
    test(close_to_its_middle_this_highlight_is_also_weaker);
    tests_of("clamp_color");
    test(a_number_between_0_and_1_stays);
    test(a_number_above_1_becomes_1_and_the_others_stay);
    test(a_number_below_0_becomes_0_and_the_others_stay);
    test(each_number_is_clamped_by_itself);
    test(a_number_that_just_fits_stays_and_one_that_just_does_not_is_clamped);
    test(a_number_above_1_becomes_1_however_bright_it_is);

    tests_of("gamma_encode");
    test(with_a_gamma_of_1_nothing_changes);
    test(a_gamma_of_2_needs_the_square_root_and_3_the_cube_root);
    test(black_stays_black_and_white_stays_white);
    test(a_gamma_of_2_2_as_of_most_displays);
    test(the_display_shows_the_colour_that_was_meant);
    test(any_gamma_is_used_unchanged);
    test(a_colour_is_encoded_however_dark_it_is);
    list_tests_with_scenes();
}

OF_STEM(list_tests)
