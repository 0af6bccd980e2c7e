// 05-quadratic-hit.c - tests of hit_sphere: the place that is seen.
#include "tests/05-quadratic.h"

static void expect_hit(Ray ray, Sphere sphere, double t)
{
    given_ray_and_sphere(ray, sphere);
    expect_number(hit_sphere(ray, sphere), t,
                  ROOT_TOLERANCE * sphere.radius / vec3_length(ray.direction));
}

START_TEST(the_arrow_of_the_deck_hits_the_near_side_of_the_sphere)
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
    for (int i = 0; i < 10; i++) {
        Aimed inside = random_inside();
        expect_hit(inside.ray, inside.sphere, inside.far);
    }
}
END_TEST

START_TEST(what_is_behind_is_not_hit)
{
    expect_hit(ray_of_the_deck(-1, -0.5), unit_sphere(), NO_HIT);
    for (int i = 0; i < 10; i++) {
        Aimed behind = random_behind();
        expect_hit(behind.ray, behind.sphere, NO_HIT);
    }
}
END_TEST

START_TEST(what_is_beside_is_not_hit)
{
    Ray ray = {vec3_of(-4, 1.25, 0), vec3_of(1, 0, 0)};
    expect_hit(ray, unit_sphere(), NO_HIT);
    for (int i = 0; i < 10; i++) {
        Aimed past = random_beside();
        expect_hit(past.ray, past.sphere, NO_HIT);
    }
}
END_TEST

// Only rays along an axis, 1 or 2 long, and whole numbers: sides of 3 and 4 have a diagonal of 5.
// So nothing is rounded, whichever of the usual formulas is used, and every right answer hits.
START_TEST(a_tangent_ray_hits)
{
    Ray ray = {vec3_of(-4, 3, 0), vec3_of(1, 0, 0)};
    expect_hit(ray, sphere_at(0, 0, 0, 3), 4);
    ray = (Ray){vec3_of(2, 10, -3), vec3_of(0, -2, 0)};
    expect_hit(ray, sphere_at(5, 6, -3, 3), 2);
    ray = (Ray){vec3_of(2, 5, -1), vec3_of(0, 0, 2)};
    expect_hit(ray, sphere_at(2, 1, 2, 4), 1.5);
}
END_TEST

// On the surface in the direction of an axis, for the same reason.
START_TEST(from_the_surface_inwards_the_other_side_is_hit)
{
    Ray ray = {vec3_of(0, 0, 5), vec3_of(0, 0, -2)};
    expect_hit(ray, sphere_at(0, 0, 2, 3), 3);
    ray = (Ray){vec3_of(-2, 3, 6), vec3_of(1, 0, 0)};
    expect_hit(ray, sphere_at(1, 3, 6, 3), 6);
}
END_TEST

START_TEST(from_the_surface_outwards_nothing_is_hit)
{
    Ray ray = {vec3_of(0, 0, 5), vec3_of(0, 0, 2)};
    expect_hit(ray, sphere_at(0, 0, 2, 3), NO_HIT);
    ray = (Ray){vec3_of(-2, 3, 6), vec3_of(-1, 0, 0)};
    expect_hit(ray, sphere_at(1, 3, 6, 3), NO_HIT);
}
END_TEST

START_TEST(a_surface_close_to_the_eye_is_hit)
{
    Ray ray = {vec3_of(0, 0, -0.99), vec3_of(0, 0, -1)};
    expect_hit(ray, sphere_at(0, 0, -2, 1), 0.01);
    ray.origin = vec3_of(0, 0, -0.97);
    for (double length = 1; length < 1e17; length *= 10) {
        ray.direction = vec3_of(0, 0, -length);
        expect_hit(ray, sphere_at(0, 0, -2, 1), 0.03 / length);
    }
}
END_TEST

// 700 to go, on a direction that is ever shorter.
START_TEST(t_may_be_of_any_size)
{
    for (double length = 1; length > 1e-17; length /= 10) {
        Ray ray = {vec3_of(0, 1, 0), vec3_of(length, 0, 0)};
        expect_hit(ray, sphere_at(800, 1, 0, 100), 700 / length);
    }
}
END_TEST

// The ray of a pixel ends on the image plane; what stands between the eye and the plane is seen.
START_TEST(what_is_in_front_of_the_image_plane_is_hit)
{
    Ray ray = {vec3_of(0, 0, 0), vec3_of(0, 0, -4)};
    expect_hit(ray, sphere_at(0, 0, -3, 1), 0.5);
}
END_TEST

// The law of scale: with the world k times as large t is k times as large, and with the direction k
// times as long it is 1/k of it. First a tiny world and a long direction, last the other way round.
START_TEST(worlds_and_directions_of_any_size_are_hit_in_the_same_place)
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
        expect_hit(aimed.ray, aimed.sphere,
                   i % 4 == 0   ? aimed.near
                   : i % 4 == 1 ? aimed.far
                                : NO_HIT);
    }
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

void list_tests_of_hit(void)
{
    tests_of("hit_sphere");
    test(the_arrow_of_the_deck_hits_the_near_side_of_the_sphere);
    test(from_outside_the_nearer_of_two_places_is_hit);
    test(t_counts_in_lengths_of_the_direction);
    test(from_inside_the_exit_is_hit);
    test(what_is_behind_is_not_hit);
    test(what_is_beside_is_not_hit);
    test(a_tangent_ray_hits);
    test(from_the_surface_inwards_the_other_side_is_hit);
    test(from_the_surface_outwards_nothing_is_hit);
    test(a_surface_close_to_the_eye_is_hit);
    test(t_may_be_of_any_size);
    test(what_is_in_front_of_the_image_plane_is_hit);
    test(worlds_and_directions_of_any_size_are_hit_in_the_same_place);
    test(a_point_on_a_sphere_that_is_aimed_at_is_hit);
}
