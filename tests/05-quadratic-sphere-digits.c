// 05-quadratic-sphere-digits.c - tests of sphere_roots beyond the slide's formula: far away,
// enormous, tiny. They cost no marks.
#include "tests/05-quadratic.h"

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

// Whatever is longest in the direction, and whichever way it goes.
START_TEST(directions_of_any_length_may_go_any_way)
{
    double length[] = {1e-200, 1e200};
    for (int i = 0; i < 12; i++) {
        vec3 axis = vec3_of(0, 0, 0);
        axis[i / 4] = i % 2 == 0 ? 1 : -1;
        double l = length[i / 2 % 2];
        Sphere sphere = {.center = 10 * axis, .radius = 5};
        expect_meetings((Ray){vec3_of(0, 0, 0), l * axis}, sphere, two(5 / l, 15 / l),
                        TOLERANCE / l);
    }
}
END_TEST

// Origin times direction is of no unusual size here; the direction is.
START_TEST(a_long_direction_from_near_the_origin_of_the_world)
{
    Ray ray = {vec3_of(1e-200, 1e-200, 1e-200), 1e200 * vec3_of(2, 3, 6)};
    expect_meetings(ray, whole_sphere(10, 3, 5), two(6e-200, 14e-200), 1e-209);
}
END_TEST

// Each alone would do; together their squares are beyond the numbers.
START_TEST(scene_and_direction_may_both_be_large_or_small)
{
    double size[] = {1e100, 1e-100};
    for (int i = 0; i < 2; i++) {
        Ray ray = {vec3_of(0, 0, 0), size[i] * vec3_of(2, 3, 6)};
        Sphere sphere = whole_sphere(10, 3, 5);
        sphere.center = sphere.center * size[i];
        sphere.radius *= size[i];
        expect_meetings(ray, sphere, two(6, 14), TOLERANCE);
    }
}
END_TEST

START_TEST(an_enormous_sphere_is_met_from_its_middle)
{
    Ray ray = {vec3_of(1, 2, 3), vec3_of(1, 0, 0)};
    expect_meetings(ray, sphere_at(1, 2, 3, 1e200), two(-1e200, 1e200), 1e190);
}
END_TEST

START_TEST(a_sphere_straight_ahead_is_met_however_far_it_is)
{
    Ray ray = {vec3_of(0, 0, 0), vec3_of(1, 0, 0)};
    expect_meetings(ray, sphere_at(1e200, 0, 0, 1), two(1e200, 1e200), 1e190);
}
END_TEST

START_TEST(what_is_no_number_meets_nothing)
{
    const double none[] = {NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 9; i++) {
        Ray ray = ray_of_the_deck(1, 0.5);
        Sphere sphere = unit_sphere();
        vec3 *part[] = {&ray.origin, &ray.direction, &sphere.center};
        (*part[i / 3])[i % 2] = none[i % 3];
        given_ray_and_sphere(ray, sphere);
        expect_no_roots(sphere_roots(ray, sphere));
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

void list_tests_of_sphere_digits(void)
{
    tests_of_extra("sphere_roots");
    test(a_small_sphere_far_away_is_met_where_it_is);
    test(a_small_sphere_far_away_is_hit_or_missed_by_a_ten_millionth);
    test(a_grazing_ray_keeps_its_short_chord);
    test(points_on_small_distant_spheres_are_met);
    test(directions_may_be_of_any_length);
    test(directions_of_any_length_may_go_any_way);
    test(a_long_direction_from_near_the_origin_of_the_world);
    test(scene_and_direction_may_both_be_large_or_small);
    test(an_enormous_sphere_is_met_from_its_middle);
    test(a_sphere_straight_ahead_is_met_however_far_it_is);
    test(what_is_no_number_meets_nothing);
    test(scenes_may_be_enormous_or_tiny);
    test(a_ray_goes_from_one_end_of_the_numbers_to_the_other);
    test(next_to_a_huge_sphere_a_short_way_keeps_its_digits);
}
