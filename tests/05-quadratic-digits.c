// 05-quadratic-digits.c - tests beyond the slide's formula, which loses digits; they cost no marks.
#include "tests/05-quadratic.h"

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
    expect_roots_of((Quadratic){1e200, -3e200, 2e200}, two(1, 2), TOLERANCE);
    expect_roots_of((Quadratic){1e-200, -3e-200, 2e-200}, two(1, 2), TOLERANCE);
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
                        ROOT_TOLERANCE * 5);
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
                        two(ahead[i] - 2001, ahead[i] + 2001), ROOT_TOLERANCE * 2001);
}
END_TEST

START_TEST(points_on_small_distant_spheres_are_met)
{
    for (int i = 0; i < 20; i++) {
        Aimed aimed = random_aimed(1e6);
        given("made so", "that the point which is met is known");
        expect_meetings(aimed.ray, aimed.sphere, two(aimed.near, aimed.far),
                        ROOT_TOLERANCE * aimed.sphere.radius / vec3_length(aimed.ray.direction));
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
                        TOLERANCE / length[i]);
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
        expect_meetings(whole_ray(), sphere, two(6 * size[i], 14 * size[i]), TOLERANCE * size[i]);
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
        expect_number(sphere_roots(ray, huge).t[0], side * height / 3, TOLERANCE * height);
    }
}
END_TEST

void list_tests_of_digits(void)
{
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
