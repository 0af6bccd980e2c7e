// 05-quadratic.c - tests of exercise 05. Expected: the deck's section, chords worked by hand, and
// what is true of any ray and sphere that were built from their hits.
#include "exercises/05-quadratic.h"

#include "tests/judge/test.h"

#include <stdio.h>
#include <string.h>

static const double tolerance = 1e-9;
static const double root_tolerance = 1e-6; // of the radius, along the ray

// ---- saying it ----------------------------------------------------------------------------------

static void given_quadratic(Quadratic q)
{
    given("a, b, c", "%s, %s, %s", number_text_to(q.a, 12).s, number_text_to(q.b, 12).s,
          number_text_to(q.c, 12).s);
}

static void given_ray_and_sphere(Ray ray, Sphere sphere)
{
    given_ray(ray);
    given_sphere(sphere);
}

static void expect_quadratic(Quadratic yours, double a, double b, double c)
{
    given("in order", "a, b, c");
    expect_vec3(vec3_of(yours.a, yours.b, yours.c), vec3_of(a, b, c), tolerance);
}

static Text roots_text(Roots roots, int digits)
{
    Text text;
    if (roots.count == 1)
        snprintf(text.s, sizeof text.s, "1 root, %.50s", number_text_to(roots.t[0], digits).s);
    else if (roots.count == 2)
        snprintf(text.s, sizeof text.s, "2 roots, %.50s and %.50s",
                 number_text_to(roots.t[0], digits).s, number_text_to(roots.t[1], digits).s);
    else
        snprintf(text.s, sizeof text.s, "%d roots", roots.count);
    return text;
}

// The tolerance is absolute; where there are fewer roots, the t that are none do not matter.
static void expect_roots(Roots yours, Roots expected, double within)
{
    bool same = yours.count == expected.count;
    for (int i = 0; same && i < expected.count; i++)
        same = fabs(yours.t[i] - expected.t[i]) <= within;
    int digits = 6;
    while (digits < 17 && !same &&
           strcmp(roots_text(yours, digits).s, roots_text(expected, digits).s) == 0)
        digits++;
    expect_law(same, roots_text(expected, digits).s, "%s", roots_text(yours, digits).s);
}

static void expect_no_roots(Roots yours)
{
    expect_roots(yours, (Roots){0}, 0);
}

static Roots two(double t, double u)
{
    return (Roots){2, {t, u}};
}

// ---- what is met --------------------------------------------------------------------------------

// The deck's section: the circle of radius 1 round the origin, seen from (-4, -1).
static Ray ray_of_the_deck(double x, double y)
{
    return (Ray){vec3_of(-4, -1, 0), vec3_of(x, y, 0)};
}

static Sphere unit_sphere(void)
{
    return (Sphere){.center = vec3_of(0, 0, 0), .radius = 1};
}

static Sphere sphere_at(double x, double y, double z, double radius)
{
    return (Sphere){.center = vec3_of(x, y, z), .radius = radius};
}

// A random sphere, and a ray that was made backwards: from a point on the sphere outwards to the
// origin. cosine is that of the angle to the surface's normal there, so that the chord inside the
// sphere is 2 r cosine.
typedef struct {
    Ray ray;
    Sphere sphere;
    double near, far; // the t of both hits
} Aimed;

static Aimed random_aimed(double radii_away)
{
    Aimed aimed;
    aimed.sphere = (Sphere){.center = random_vec3(-5, 5), .radius = random_number(0.1, 3)};
    vec3 normal = random_unit(), back = random_unit();
    while (vec3_dot(normal, back) < 0.3)
        back = random_unit();
    double r = aimed.sphere.radius, length = random_number(0.1, 10);
    double distance = radii_away * r;
    vec3 point = aimed.sphere.center + r * normal;
    aimed.ray = (Ray){point + distance * back, -length * back};
    aimed.near = distance / length;
    aimed.far = (distance + 2 * r * vec3_dot(normal, back)) / length;
    return aimed;
}

// ---- to_object_coordinates ----------------------------------------------------------------------

START_TEST(the_origin_is_seen_from_the_centre_of_the_sphere)
{
    Ray ray = {vec3_of(1, 2, 3), vec3_of(0, 0, -1)};
    Sphere sphere = sphere_at(4, -1, 1, 2);
    given_ray_and_sphere(ray, sphere);
    given("looking at", "the origin");
    expect_vec3(to_object_coordinates(ray, sphere).origin, vec3_of(-3, 3, 2), tolerance);
}
END_TEST

START_TEST(the_direction_stays_as_it_is)
{
    Ray ray = {vec3_of(1, 2, 3), vec3_of(2, -3, 6)};
    Sphere sphere = sphere_at(4, -1, 1, 2);
    given_ray_and_sphere(ray, sphere);
    given("looking at", "the direction");
    expect_vec3(to_object_coordinates(ray, sphere).direction, vec3_of(2, -3, 6), tolerance);
}
END_TEST

START_TEST(a_place_that_was_chosen_round_the_centre_comes_back)
{
    for (int i = 0; i < 20; i++) {
        vec3 place = random_vec3(-9, 9);
        Sphere sphere = {.center = random_vec3(-9, 9), .radius = random_number(0.1, 5)};
        Ray ray = {sphere.center + place, random_vec3(-2, 2)};
        given_ray_and_sphere(ray, sphere);
        given("looking at", "the origin");
        expect_vec3(to_object_coordinates(ray, sphere).origin, place, tolerance);
    }
}
END_TEST

// ---- object_quadratic ---------------------------------------------------------------------------

static void given_object_ray(Ray ray, double radius)
{
    given_ray(ray);
    given_number("radius", radius);
}

// By hand: 0.89^2 + 0.45^2, 2 (-4 * 0.89 - 0.45), 16 + 1 - 1.
START_TEST(the_arrow_of_the_deck_gives_0_9946_and_minus_8_02_and_16)
{
    Ray ray = ray_of_the_deck(0.89, 0.45);
    given_object_ray(ray, 1);
    expect_quadratic(object_quadratic(ray, 1), 0.9946, -8.02, 16);
}
END_TEST

// By hand: 1 + 1/4, 2 (-4 - 1/2), 16 + 1 - 1. The direction is not unit.
START_TEST(the_hits_drawn_in_the_deck_give_1_25_and_minus_9_and_16)
{
    Ray ray = ray_of_the_deck(1, 0.5);
    given_object_ray(ray, 1);
    expect_quadratic(object_quadratic(ray, 1), 1.25, -9, 16);
}
END_TEST

// By hand: 4 + 1 + 4, 2 (2 - 2 - 6), 1 + 4 + 9 - 9.
START_TEST(a_radius_of_3_and_a_direction_of_length_3)
{
    Ray ray = {vec3_of(1, -2, 3), vec3_of(2, 1, -2)};
    given_object_ray(ray, 3);
    expect_quadratic(object_quadratic(ray, 3), 9, -12, 5);
}
END_TEST

START_TEST(c_is_negative_for_a_ray_that_begins_inside)
{
    Ray ray = {vec3_of(0, 0, 1), vec3_of(0, 0, 2)};
    given_object_ray(ray, 4);
    expect_quadratic(object_quadratic(ray, 4), 4, 4, -15);
}
END_TEST

// What the equation says: at every t, how far the point's squared distance from the centre is
// from the squared radius.
static double distance_squared_less_radius_squared(Ray ray, vec3 center, double radius, double t)
{
    double distance = vec3_length(ray.origin + t * ray.direction - center);
    return (distance - radius) * (distance + radius);
}

START_TEST(at_every_t_it_is_the_squared_distance_less_the_squared_radius)
{
    for (int i = 0; i < 30; i++) {
        Ray ray = {random_vec3(-5, 5), random_vec3(-2, 2)};
        double radius = random_number(0.1, 5), t = random_number(-3, 3);
        given_object_ray(ray, radius);
        given("looking at", "a t^2 + b t + c for t = %s", number_text_to(t, 10).s);
        Quadratic q = object_quadratic(ray, radius);
        expect_number(q.a * t * t + q.b * t + q.c,
                      distance_squared_less_radius_squared(ray, vec3_of(0, 0, 0), radius, t), 1e-6);
    }
}
END_TEST

// ---- world_quadratic ----------------------------------------------------------------------------

START_TEST(a_sphere_at_the_origin_of_the_world_gives_what_object_coordinates_give)
{
    Ray ray = ray_of_the_deck(1, 0.5);
    given_ray_and_sphere(ray, unit_sphere());
    expect_quadratic(world_quadratic(ray, unit_sphere()), 1.25, -9, 16);
}
END_TEST

// From the centre the origin is (1, -2, 3), as in the test of object coordinates.
START_TEST(a_sphere_off_the_origin_of_the_world)
{
    Ray ray = {vec3_of(1, 2, 3), vec3_of(2, 1, -2)};
    Sphere sphere = sphere_at(0, 4, 0, 3);
    given_ray_and_sphere(ray, sphere);
    expect_quadratic(world_quadratic(ray, sphere), 9, -12, 5);
}
END_TEST

START_TEST(moving_the_eye_and_the_sphere_together_changes_nothing)
{
    vec3 moves[] = {vec3_of(10, 0, 0), vec3_of(0, -20, 5), vec3_of(7, 8, -9)};
    for (int i = 0; i < 3; i++) {
        Ray ray = {vec3_of(-4, -1, 0) + moves[i], vec3_of(1, 0.5, 0)};
        Sphere sphere = {.center = moves[i], .radius = 1};
        given_ray_and_sphere(ray, sphere);
        expect_quadratic(world_quadratic(ray, sphere), 1.25, -9, 16);
    }
}
END_TEST

START_TEST(in_the_world_too_it_is_the_squared_distance_less_the_squared_radius)
{
    for (int i = 0; i < 30; i++) {
        Ray ray = {random_vec3(-5, 5), random_vec3(-2, 2)};
        Sphere sphere = {.center = random_vec3(-5, 5), .radius = random_number(0.1, 5)};
        double t = random_number(-3, 3);
        given_ray_and_sphere(ray, sphere);
        given("looking at", "a t^2 + b t + c for t = %s", number_text_to(t, 10).s);
        Quadratic q = world_quadratic(ray, sphere);
        expect_number(q.a * t * t + q.b * t + q.c,
                      distance_squared_less_radius_squared(ray, sphere.center, sphere.radius, t),
                      1e-6);
    }
}
END_TEST

// ---- quadratic_roots ----------------------------------------------------------------------------

static void expect_roots_of(Quadratic q, Roots expected, double within)
{
    given_quadratic(q);
    expect_roots(quadratic_roots(q), expected, within);
}

// The quadratic with these roots.
static Quadratic with_roots(double a, double t, double u)
{
    return (Quadratic){a, -a * (t + u), a * t * u};
}

// By hand: (9 - 1) / 2.5 and (9 + 1) / 2.5.
START_TEST(the_roots_of_the_hits_drawn_in_the_deck_are_3_2_and_4)
{
    expect_roots_of((Quadratic){1.25, -9, 16}, two(3.2, 4), tolerance);
}
END_TEST

START_TEST(the_roots_of_the_arrow_of_the_deck_are_3_622_and_4_442)
{
    expect_roots_of((Quadratic){0.9946, -8.02, 16}, two(3.622, 4.442), 1e-3);
}
END_TEST

START_TEST(roots_that_were_chosen_come_back)
{
    expect_roots_of(with_roots(1, 2, 3), two(2, 3), tolerance);
    expect_roots_of(with_roots(2, -1, 5), two(-1, 5), tolerance);
    expect_roots_of(with_roots(0.5, -6, -4), two(-6, -4), tolerance);
    for (int i = 0; i < 30; i++) {
        double a = random_number(0.1, 5), t = random_number(-9, 9), gap = random_number(0.1, 9);
        expect_roots_of(with_roots(a, t, t + gap), two(t, t + gap), tolerance);
    }
}
END_TEST

START_TEST(roots_come_in_ascending_order_even_when_a_is_negative)
{
    expect_roots_of(with_roots(-1, 2, 3), two(2, 3), tolerance);
    expect_roots_of(with_roots(-4, -7, 1), two(-7, 1), tolerance);
}
END_TEST

START_TEST(a_double_root_counts_as_two)
{
    expect_roots_of((Quadratic){1, -8, 16}, two(4, 4), tolerance);
    expect_roots_of((Quadratic){2, 12, 18}, two(-3, -3), tolerance);
    expect_roots_of((Quadratic){3, 0, 0}, two(0, 0), tolerance);
}
END_TEST

START_TEST(there_are_no_roots_where_the_parabola_stays_on_one_side)
{
    Quadratic none[] = {{1, 0, 1}, {2, -4, 9}, {1, 1, 0.5}, {-1, 2, -5}};
    for (int i = 0; i < 4; i++) {
        given_quadratic(none[i]);
        expect_no_roots(quadratic_roots(none[i]));
    }
}
END_TEST

START_TEST(where_b_is_0_the_roots_are_opposite)
{
    expect_roots_of((Quadratic){4, 0, -9}, two(-1.5, 1.5), tolerance);
}
END_TEST

START_TEST(where_c_is_0_one_root_is_0)
{
    expect_roots_of((Quadratic){2, -6, 0}, two(0, 3), tolerance);
    expect_roots_of((Quadratic){2, 6, 0}, two(-3, 0), tolerance);
}
END_TEST

START_TEST(where_a_is_0_it_is_a_line_with_one_root)
{
    expect_roots_of((Quadratic){0, 2, -6}, (Roots){1, {3}}, tolerance);
    expect_roots_of((Quadratic){0, -4, 0}, (Roots){1, {0}}, tolerance);
}
END_TEST

START_TEST(where_a_and_b_are_0_there_are_no_roots)
{
    double c[] = {5, -5, 0};
    for (int i = 0; i < 3; i++) {
        given_quadratic((Quadratic){0, 0, c[i]});
        expect_no_roots(quadratic_roots((Quadratic){0, 0, c[i]}));
    }
}
END_TEST

// ---- quadratic_roots, extra ---------------------------------------------------------------------

// t^2 - 10^8 t + 1: the product of the roots is 1, their sum 10^8; so 10^-8 to 16 digits.
START_TEST(a_small_root_beside_a_large_one_keeps_its_digits)
{
    given_quadratic((Quadratic){1, -1e8, 1});
    expect_number(quadratic_roots((Quadratic){1, -1e8, 1}).t[0], 1e-8, 1e-17);
    given_quadratic((Quadratic){1, 1e8, 1});
    expect_number(quadratic_roots((Quadratic){1, 1e8, 1}).t[1], -1e-8, 1e-17);
}
END_TEST

// Kahan's example: a + b + c is exactly 0, so 1 is a root, and the other is c / a.
START_TEST(roots_that_are_nearly_equal_keep_their_digits)
{
    Quadratic q = {94906265.625, -189812534, 94906268.375};
    expect_roots_of(q, two(1, 94906268.375 / 94906265.625), 1e-12);
}
END_TEST

START_TEST(enormous_and_tiny_coefficients_neither_overflow_nor_vanish)
{
    expect_roots_of((Quadratic){1e200, -3e200, 2e200}, two(1, 2), tolerance);
    expect_roots_of((Quadratic){1e-200, -3e-200, 2e-200}, two(1, 2), tolerance);
}
END_TEST

// ---- sphere_roots -------------------------------------------------------------------------------

static void expect_meetings(Ray ray, Sphere sphere, Roots expected, double within)
{
    given_ray_and_sphere(ray, sphere);
    expect_roots(sphere_roots(ray, sphere), expected, within);
}

START_TEST(the_line_drawn_in_the_deck_meets_the_sphere_at_3_2_and_4)
{
    expect_meetings(ray_of_the_deck(1, 0.5), unit_sphere(), two(3.2, 4), root_tolerance);
}
END_TEST

START_TEST(a_sphere_off_the_origin_is_met_in_the_same_places)
{
    Ray ray = {vec3_of(3, 8, -2), vec3_of(1, 0.5, 0)};
    expect_meetings(ray, sphere_at(7, 9, -2, 1), two(3.2, 4), root_tolerance);
}
END_TEST

START_TEST(what_is_behind_the_origin_is_met_too)
{
    expect_meetings(ray_of_the_deck(-1, -0.5), unit_sphere(), two(-4, -3.2), root_tolerance);
}
END_TEST

START_TEST(from_the_middle_it_is_met_on_both_sides)
{
    Ray ray = {vec3_of(1, 1, 1), vec3_of(0, 0, 2)};
    expect_meetings(ray, sphere_at(1, 1, 1, 3), two(-1.5, 1.5), root_tolerance);
}
END_TEST

START_TEST(a_tangent_line_meets_it_twice_in_one_place)
{
    Ray ray = {vec3_of(-4, 1, 0), vec3_of(1, 0, 0)};
    expect_meetings(ray, unit_sphere(), two(4, 4), root_tolerance);
}
END_TEST

START_TEST(a_line_that_passes_beside_it_does_not_meet_it)
{
    Ray ray = {vec3_of(-4, 1.25, 0), vec3_of(1, 0, 0)};
    given_ray_and_sphere(ray, unit_sphere());
    expect_no_roots(sphere_roots(ray, unit_sphere()));
    ray = ray_of_the_deck(1, -0.5);
    given_ray_and_sphere(ray, unit_sphere());
    expect_no_roots(sphere_roots(ray, unit_sphere()));
}
END_TEST

START_TEST(the_chord_is_twice_the_radius_times_the_cosine)
{
    for (int i = 0; i < 50; i++) {
        Aimed aimed = random_aimed(random_number(0.1, 1000));
        given("made so", "that the angle at the surface is known");
        expect_meetings(aimed.ray, aimed.sphere, two(aimed.near, aimed.far),
                        root_tolerance * aimed.sphere.radius / vec3_length(aimed.ray.direction));
    }
}
END_TEST

// ---- sphere_roots, extra ------------------------------------------------------------------------

// (2, 3, 6) and (3, -6, 2) are at right angles and 7 long. So with the ray from the origin along
// the first, and a centre so many of it ahead and so many of the other aside, everything is a whole
// number: chords come from whole right-angled triangles.
static Ray whole_ray(void)
{
    return (Ray){vec3_of(0, 0, 0), vec3_of(2, 3, 6)};
}

static Sphere whole_sphere(double ahead, double aside, double radius_in_sevens)
{
    return (Sphere){.center = ahead * vec3_of(2, 3, 6) + aside * vec3_of(3, -6, 2),
                    .radius = 7 * radius_in_sevens};
}

// The triangle 3, 4, 5.
START_TEST(a_small_sphere_far_away_is_met_where_it_is)
{
    double ahead[] = {1234567, 7654321, 12345679, 98765431};
    for (int i = 0; i < 4; i++)
        expect_meetings(whole_ray(), whole_sphere(ahead[i], 3, 5), two(ahead[i] - 4, ahead[i] + 4),
                        root_tolerance * 5);
}
END_TEST

START_TEST(a_small_sphere_far_away_is_hit_or_missed_by_a_ten_millionth)
{
    double ahead[] = {1234567, 2345677, 3456789, 7654321, 9876543};
    for (int i = 0; i < 5; i++) {
        given_ray_and_sphere(whole_ray(), whole_sphere(ahead[i], 5, 5 * (1 - 1e-7)));
        expect_no_roots(sphere_roots(whole_ray(), whole_sphere(ahead[i], 5, 5 * (1 - 1e-7))));
        given_ray_and_sphere(whole_ray(), whole_sphere(ahead[i], 5, 5 * (1 + 1e-7)));
        given("looking at", "the number of roots");
        expect_int(sphere_roots(whole_ray(), whole_sphere(ahead[i], 5, 5 * (1 + 1e-7))).count, 2);
    }
}
END_TEST

// The triangle 2002000, 2001, 2002001: half the chord is a thousandth of the radius.
START_TEST(a_grazing_ray_keeps_its_short_chord)
{
    double ahead[] = {1234567891, 3141592653};
    for (int i = 0; i < 2; i++)
        expect_meetings(whole_ray(), whole_sphere(ahead[i], 2002000, 2002001),
                        two(ahead[i] - 2001, ahead[i] + 2001), root_tolerance * 2001);
}
END_TEST

START_TEST(points_on_small_distant_spheres_are_met)
{
    for (int i = 0; i < 20; i++) {
        Aimed aimed = random_aimed(1e6);
        given("made so", "that the point which is met is known");
        expect_meetings(aimed.ray, aimed.sphere, two(aimed.near, aimed.far),
                        root_tolerance * aimed.sphere.radius / vec3_length(aimed.ray.direction));
    }
}
END_TEST

START_TEST(directions_may_be_of_any_length)
{
    double length[] = {1e-200, 1e-300, 1e200, 1e300};
    for (int i = 0; i < 4; i++) {
        Ray ray = whole_ray();
        ray.direction = ray.direction * length[i];
        expect_meetings(ray, whole_sphere(10, 3, 5), two(6 / length[i], 14 / length[i]),
                        tolerance / length[i]);
    }
}
END_TEST

START_TEST(scenes_may_be_enormous_or_tiny)
{
    double size[] = {1e200, 1e-200};
    for (int i = 0; i < 2; i++) {
        Sphere sphere = whole_sphere(10, 3, 5);
        sphere.center = sphere.center * size[i];
        sphere.radius *= size[i];
        expect_meetings(whole_ray(), sphere, two(6 * size[i], 14 * size[i]), tolerance * size[i]);
    }
}
END_TEST

// The two are 3 * 10^308 apart, which no double holds.
START_TEST(a_ray_goes_from_one_end_of_the_numbers_to_the_other)
{
    Ray ray = {vec3_of(-1.5e308, 0, 0), vec3_of(4, 0, 0)};
    expect_meetings(ray, sphere_at(1.5e308, 0, 0, 1e308), two(0.5e308, 1e308), 1e300);
}
END_TEST

// Straight down from a millionth (2^-20) above a huge sphere, and from below. 1234567 + 2^-20 is a
// double; its square is not.
START_TEST(next_to_a_huge_sphere_a_short_way_keeps_its_digits)
{
    const double height = 0x1p-20;
    Sphere huge = sphere_at(0, 0, 0, 1234567);
    for (int side = -1; side <= 1; side += 2) {
        Ray ray = {vec3_of(0, huge.radius + side * height, 0), vec3_of(0, -3, 0)};
        given("from", "%s the surface, straight down", side > 0 ? "above" : "below");
        given_ray_and_sphere(ray, huge);
        given("looking at", "the first root");
        expect_number(sphere_roots(ray, huge).t[0], side * height / 3, tolerance * height);
    }
}
END_TEST

// ---- hit_sphere ---------------------------------------------------------------------------------

static void expect_hit(Ray ray, Sphere sphere, double t)
{
    given_ray_and_sphere(ray, sphere);
    expect_number(hit_sphere(ray, sphere), t,
                  root_tolerance * sphere.radius / vec3_length(ray.direction));
}

START_TEST(the_arrow_of_the_deck_hits_at_3_622)
{
    given_ray_and_sphere(ray_of_the_deck(0.89, 0.45), unit_sphere());
    expect_number(hit_sphere(ray_of_the_deck(0.89, 0.45), unit_sphere()), 3.622, 1e-3);
}
END_TEST

START_TEST(from_outside_the_nearer_of_two_places_is_hit)
{
    expect_hit(ray_of_the_deck(1, 0.5), unit_sphere(), 3.2);
    Ray ray = {vec3_of(3, 8, -2), vec3_of(1, 0.5, 0)};
    expect_hit(ray, sphere_at(7, 9, -2, 1), 3.2);
}
END_TEST

// 10 away, radius 2: 8 to go.
START_TEST(t_counts_in_lengths_of_the_direction)
{
    double length[] = {1, 2, 16, 0.25};
    for (int i = 0; i < 4; i++) {
        Ray ray = {vec3_of(1, 1, 5), vec3_of(0, 0, -length[i])};
        expect_hit(ray, sphere_at(1, 1, -5, 2), 8 / length[i]);
    }
}
END_TEST

START_TEST(from_inside_the_exit_is_hit)
{
    Ray ray = {vec3_of(1, 1, 2), vec3_of(0, 0, 2)};
    expect_hit(ray, sphere_at(1, 1, 1, 3), 1);
    ray.direction = vec3_of(0, 0, -2);
    expect_hit(ray, sphere_at(1, 1, 1, 3), 2);
}
END_TEST

START_TEST(what_is_behind_is_not_hit)
{
    expect_hit(ray_of_the_deck(-1, -0.5), unit_sphere(), NO_HIT);
}
END_TEST

START_TEST(what_is_beside_is_not_hit)
{
    Ray ray = {vec3_of(-4, 1.25, 0), vec3_of(1, 0, 0)};
    expect_hit(ray, unit_sphere(), NO_HIT);
}
END_TEST

START_TEST(a_tangent_ray_hits)
{
    Ray ray = {vec3_of(-4, 1, 0), vec3_of(1, 0, 0)};
    expect_hit(ray, unit_sphere(), 4);
    ray = (Ray){vec3_of(2, 10, -3), vec3_of(0, -2, 0)};
    expect_hit(ray, sphere_at(5, 4, -3, 3), 3);
}
END_TEST

// The direction (2, 3, 6) is 7 long: from (2, 3, 6) to its opposite is twice that.
START_TEST(from_the_surface_inwards_the_other_side_is_hit)
{
    Ray ray = {vec3_of(0, 0, 5), vec3_of(0, 0, -2)};
    expect_hit(ray, sphere_at(0, 0, 2, 3), 3);
    ray = (Ray){vec3_of(2, 3, 6), vec3_of(-2, -3, -6)};
    expect_hit(ray, sphere_at(0, 0, 0, 7), 2);
}
END_TEST

START_TEST(from_the_surface_outwards_nothing_is_hit)
{
    Ray ray = {vec3_of(0, 0, 5), vec3_of(0, 0, 2)};
    expect_hit(ray, sphere_at(0, 0, 2, 3), NO_HIT);
    ray = (Ray){vec3_of(2, 3, 6), vec3_of(2, 3, 6)};
    expect_hit(ray, sphere_at(0, 0, 0, 7), NO_HIT);
}
END_TEST

START_TEST(a_surface_close_to_the_eye_is_hit)
{
    Ray ray = {vec3_of(0, 0, -0.99), vec3_of(0, 0, -1)};
    expect_hit(ray, sphere_at(0, 0, -2, 1), 0.01);
    ray.direction = vec3_of(0, 0, -1000);
    expect_hit(ray, sphere_at(0, 0, -2, 1), 0.00001);
}
END_TEST

// The ray of a pixel ends on the image plane; what stands between the eye and the plane is seen.
START_TEST(what_is_in_front_of_the_image_plane_is_hit)
{
    Ray ray = {vec3_of(0, 0, 0), vec3_of(0, 0, -4)};
    expect_hit(ray, sphere_at(0, 0, -3, 1), 0.5);
}
END_TEST

START_TEST(a_point_on_a_sphere_that_is_aimed_at_is_hit)
{
    for (int i = 0; i < 50; i++) {
        Aimed aimed = random_aimed(random_number(0.1, 1000));
        given("made so", "that the point which is met is known");
        expect_hit(aimed.ray, aimed.sphere, aimed.near);
    }
}
END_TEST

void list_tests(void)
{
    tests_of("to_object_coordinates");
    test(the_origin_is_seen_from_the_centre_of_the_sphere);
    test(the_direction_stays_as_it_is);
    test(a_place_that_was_chosen_round_the_centre_comes_back);
    tests_of("object_quadratic");
    test(the_arrow_of_the_deck_gives_0_9946_and_minus_8_02_and_16);
    test(the_hits_drawn_in_the_deck_give_1_25_and_minus_9_and_16);
    test(a_radius_of_3_and_a_direction_of_length_3);
    test(c_is_negative_for_a_ray_that_begins_inside);
    test(at_every_t_it_is_the_squared_distance_less_the_squared_radius);
    tests_of("world_quadratic");
    test(a_sphere_at_the_origin_of_the_world_gives_what_object_coordinates_give);
    test(a_sphere_off_the_origin_of_the_world);
    test(moving_the_eye_and_the_sphere_together_changes_nothing);
    test(in_the_world_too_it_is_the_squared_distance_less_the_squared_radius);
    tests_of("quadratic_roots");
    test(the_roots_of_the_hits_drawn_in_the_deck_are_3_2_and_4);
    test(the_roots_of_the_arrow_of_the_deck_are_3_622_and_4_442);
    test(roots_that_were_chosen_come_back);
    test(roots_come_in_ascending_order_even_when_a_is_negative);
    test(a_double_root_counts_as_two);
    test(there_are_no_roots_where_the_parabola_stays_on_one_side);
    test(where_b_is_0_the_roots_are_opposite);
    test(where_c_is_0_one_root_is_0);
    test(where_a_is_0_it_is_a_line_with_one_root);
    test(where_a_and_b_are_0_there_are_no_roots);
    tests_of("sphere_roots");
    test(the_line_drawn_in_the_deck_meets_the_sphere_at_3_2_and_4);
    test(a_sphere_off_the_origin_is_met_in_the_same_places);
    test(what_is_behind_the_origin_is_met_too);
    test(from_the_middle_it_is_met_on_both_sides);
    test(a_tangent_line_meets_it_twice_in_one_place);
    test(a_line_that_passes_beside_it_does_not_meet_it);
    test(the_chord_is_twice_the_radius_times_the_cosine);
    tests_of("hit_sphere");
    test(the_arrow_of_the_deck_hits_at_3_622);
    test(from_outside_the_nearer_of_two_places_is_hit);
    test(t_counts_in_lengths_of_the_direction);
    test(from_inside_the_exit_is_hit);
    test(what_is_behind_is_not_hit);
    test(what_is_beside_is_not_hit);
    test(a_tangent_ray_hits);
    test(from_the_surface_inwards_the_other_side_is_hit);
    test(from_the_surface_outwards_nothing_is_hit);
    test(a_surface_close_to_the_eye_is_hit);
    test(what_is_in_front_of_the_image_plane_is_hit);
    test(a_point_on_a_sphere_that_is_aimed_at_is_hit);

    // Beyond the slide's formula.
    tests_of_extra("quadratic_roots");
    test(a_small_root_beside_a_large_one_keeps_its_digits);
    test(roots_that_are_nearly_equal_keep_their_digits);
    test(enormous_and_tiny_coefficients_neither_overflow_nor_vanish);
    tests_of_extra("sphere_roots");
    test(a_small_sphere_far_away_is_met_where_it_is);
    test(a_small_sphere_far_away_is_hit_or_missed_by_a_ten_millionth);
    test(a_grazing_ray_keeps_its_short_chord);
    test(points_on_small_distant_spheres_are_met);
    test(directions_may_be_of_any_length);
    test(scenes_may_be_enormous_or_tiny);
    test(a_ray_goes_from_one_end_of_the_numbers_to_the_other);
    test(next_to_a_huge_sphere_a_short_way_keeps_its_digits);
}
