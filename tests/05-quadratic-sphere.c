// 05-quadratic-sphere.c - tests of sphere_roots: where a whole line meets a sphere.
#include "tests/05-quadratic.h"

static void expect_aimed(Aimed aimed)
{
    given("made so", "that the angle at the surface is known");
    expect_meetings(aimed.ray, aimed.sphere, two(aimed.near, aimed.far),
                    ROOT_TOLERANCE * aimed.sphere.radius / vec3_length(aimed.ray.direction));
}

START_TEST(the_line_drawn_in_the_deck_meets_the_sphere_in_the_hits_drawn)
{
    expect_meetings(ray_of_the_deck(1, 0.5), unit_sphere(), two(3.2, 4), ROOT_TOLERANCE);
}
END_TEST

START_TEST(a_sphere_off_the_origin_is_met_in_the_same_places)
{
    Ray ray = {vec3_of(3, 8, -2), vec3_of(1, 0.5, 0)};
    expect_meetings(ray, sphere_at(7, 9, -2, 1), two(3.2, 4), ROOT_TOLERANCE);
}
END_TEST

START_TEST(what_is_behind_the_origin_is_met_too)
{
    expect_meetings(ray_of_the_deck(-1, -0.5), unit_sphere(), two(-4, -3.2), ROOT_TOLERANCE);
    for (int i = 0; i < 10; i++)
        expect_aimed(i % 2 == 0 ? random_behind() : random_inside());
}
END_TEST

START_TEST(from_the_middle_it_is_met_on_both_sides)
{
    Ray ray = {vec3_of(1, 1, 1), vec3_of(0, 0, 2)};
    expect_meetings(ray, sphere_at(1, 1, 1, 3), two(-1.5, 1.5), ROOT_TOLERANCE);
}
END_TEST

START_TEST(a_tangent_line_meets_it_twice_in_one_place)
{
    // As for hit_sphere: nothing is rounded, whichever of the usual formulas is used.
    Ray ray = {vec3_of(-4, 3, 0), vec3_of(1, 0, 0)};
    expect_meetings(ray, sphere_at(0, 0, 0, 3), two(4, 4), ROOT_TOLERANCE * 3);
    ray = (Ray){vec3_of(2, 5, -1), vec3_of(0, 0, 2)};
    expect_meetings(ray, sphere_at(2, 1, 2, 4), two(1.5, 1.5), ROOT_TOLERANCE * 2);
}
END_TEST

START_TEST(a_line_that_touches_it_where_it_starts_meets_it_at_0)
{
    Ray ray = {vec3_of(3, 5, 0), vec3_of(0, 0, 2)};
    expect_meetings(ray, sphere_at(3, 4, 0, 1), two(0, 0), ROOT_TOLERANCE);
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
    for (int i = 0; i < 10; i++) {
        Aimed past = random_beside();
        given_ray_and_sphere(past.ray, past.sphere);
        expect_no_roots(sphere_roots(past.ray, past.sphere));
    }
}
END_TEST

START_TEST(the_chord_is_twice_the_radius_times_the_cosine)
{
    for (int i = 0; i < 50; i++)
        expect_aimed(random_aimed(random_number(0.1, 1000)));
}
END_TEST

// From 3 away, with a radius of 2: 1 and 5 to go, on a direction that is ever longer or shorter.
START_TEST(both_places_may_be_of_any_size)
{
    for (int power = -16; power <= 16; power++) {
        double length = pow(10, power);
        Ray ray = {vec3_of(0, 1, 0), vec3_of(length, 0, 0)};
        expect_meetings(ray, sphere_at(3, 1, 0, 2), two(1 / length, 5 / length),
                        ROOT_TOLERANCE / length);
    }
}
END_TEST

START_TEST(worlds_and_directions_of_any_size_are_met_in_the_same_places)
{
    enum { COUNT = 25 };
    for (int i = 0; i < COUNT; i++) {
        Aimed aimed = i % 4 == 0   ? random_aimed(random_number(1, 10))
                      : i % 4 == 1 ? random_inside()
                      : i % 4 == 2 ? random_behind()
                                   : random_beside();
        double world = pow(random_scale(i, COUNT), 1.5);
        double length = random_scale(i % 2 == 0 ? COUNT - 1 - i : i, COUNT);
        aimed = scaled(aimed, world, length);
        if (i % 4 < 3) {
            expect_aimed(aimed);
            continue;
        }
        given_ray_and_sphere(aimed.ray, aimed.sphere);
        expect_no_roots(sphere_roots(aimed.ray, aimed.sphere));
    }
}
END_TEST

void list_tests_of_sphere(void)
{
    tests_of("sphere_roots");
    test(the_line_drawn_in_the_deck_meets_the_sphere_in_the_hits_drawn);
    test(a_sphere_off_the_origin_is_met_in_the_same_places);
    test(what_is_behind_the_origin_is_met_too);
    test(from_the_middle_it_is_met_on_both_sides);
    test(a_tangent_line_meets_it_twice_in_one_place);
    test(a_line_that_touches_it_where_it_starts_meets_it_at_0);
    test(a_line_that_passes_beside_it_does_not_meet_it);
    test(the_chord_is_twice_the_radius_times_the_cosine);
    test(both_places_may_be_of_any_size);
    test(worlds_and_directions_of_any_size_are_met_in_the_same_places);
}
