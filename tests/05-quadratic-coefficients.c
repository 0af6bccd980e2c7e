// 05-quadratic-coefficients.c - tests of the ray seen from the sphere, and of a, b, c.
#include "tests/05-quadratic.h"

// ---- to_object_coordinates ----------------------------------------------------------------------

START_TEST(the_origin_is_seen_from_the_centre_of_the_sphere)
{
    Ray ray = {vec3_of(1, 2, 3), vec3_of(0, 0, -1)};
    Sphere sphere = sphere_at(4, -1, 1, 2);
    given_ray_and_sphere(ray, sphere);
    given("looking at", "the origin");
    expect_vec3(to_object_coordinates(ray, sphere).origin, vec3_of(-3, 3, 2), TOLERANCE);
}
END_TEST

START_TEST(the_direction_stays_as_it_is)
{
    Ray ray = {vec3_of(1, 2, 3), vec3_of(2, -3, 6)};
    Sphere sphere = sphere_at(4, -1, 1, 2);
    given_ray_and_sphere(ray, sphere);
    given("looking at", "the direction");
    expect_vec3(to_object_coordinates(ray, sphere).direction, vec3_of(2, -3, 6), TOLERANCE);
}
END_TEST

START_TEST(a_place_that_was_chosen_round_the_centre_comes_back)
{
    for (int i = 0; i < 20; i++) {
        vec3 place = random_vec3(-9, 9);
        Sphere sphere = random_sphere(9, 0.1, 5);
        Ray ray = {sphere.center + place, random_vec3(-2, 2)};
        given_ray_and_sphere(ray, sphere);
        given("looking at", "the origin");
        Ray seen = to_object_coordinates(ray, sphere);
        expect_vec3(seen.origin, place, TOLERANCE);
        given_ray_and_sphere(ray, sphere);
        given("looking at", "the direction");
        expect_vec3(seen.direction, ray.direction, TOLERANCE);
    }
}
END_TEST

START_TEST(worlds_and_directions_may_be_of_any_size)
{
    enum { COUNT = 13 };
    for (int i = 0; i < COUNT; i++) {
        double world = random_scale(i, COUNT), length = random_scale(COUNT - 1 - i, COUNT);
        vec3 place = world * random_vec3(-9, 9);
        Sphere sphere = random_sphere(9, 0.1, 5);
        sphere.center *= world;
        sphere.radius *= world;
        Ray ray = {sphere.center + place, length * random_vec3(-2, 2)};
        given_ray_and_sphere(ray, sphere);
        given("looking at", "the origin");
        Ray seen = to_object_coordinates(ray, sphere);
        expect_vec3(seen.origin, place, TOLERANCE * world);
        given_ray_and_sphere(ray, sphere);
        given("looking at", "the direction");
        expect_vec3(seen.direction, ray.direction, TOLERANCE * length);
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
START_TEST(the_equation_of_the_arrow_of_the_deck)
{
    Ray ray = ray_of_the_deck(0.89, 0.45);
    given_object_ray(ray, 1);
    expect_quadratic(object_quadratic(ray, 1), 0.9946, -8.02, 16);
}
END_TEST

// By hand: 1 + 1/4, 2 (-4 - 1/2), 16 + 1 - 1. The direction is not unit.
START_TEST(the_equation_of_the_ray_through_the_hits_drawn_in_the_deck)
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

// By hand: 1.0001^2, 2 * 0.5 * 1.0001, 0.25 - 1/16; and 0.9999^2. None of them is 1.
START_TEST(a_direction_that_is_nearly_unit_is_not_unit)
{
    Ray ray = {vec3_of(0.5, 0, 0), vec3_of(1.0001, 0, 0)};
    given_object_ray(ray, 0.25);
    expect_quadratic(object_quadratic(ray, 0.25), 1.00020001, 1.0001, 0.1875);
    ray = (Ray){vec3_of(0, -0.5, 0), vec3_of(0, 0.9999, 0)};
    given_object_ray(ray, 0.25);
    expect_quadratic(object_quadratic(ray, 0.25), 0.99980001, -0.9999, 0.1875);
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
        Ray ray = random_ray(5, 2);
        double radius = random_number(0.1, 5), t = random_number(-3, 3);
        given_object_ray(ray, radius);
        given("looking at", "a t^2 + b t + c for t = %s", number_text_to(t, 10).s);
        Quadratic q = object_quadratic(ray, radius);
        expect_number(q.a * t * t + q.b * t + q.c,
                      distance_squared_less_radius_squared(ray, vec3_of(0, 0, 0), radius, t), 1e-6);
    }
}
END_TEST

// A ray whose angle to the line from its origin to the centre is known, in a world of any size; the
// direction is a little longer or shorter than that world is large. size: of the numbers that go
// in.
typedef struct {
    Ray ray; // in object coordinates
    double radius, size;
    Quadratic quadratic;
} Angled;

static Angled random_angled(double world)
{
    vec3 way = random_unit(), aside = vec3_unit(vec3_cross(way, random_unit()));
    double distance = world * random_number(0.1, 5), radius = world * random_number(0.1, 5);
    double length = world * pow(10, random_number(-2, 2)), angle = random_number(0, PI);
    vec3 origin = distance * (cos(angle) * way + sin(angle) * aside);
    return (Angled){{origin, length * way},
                    radius,
                    distance + radius + length,
                    {length * length, 2 * distance * length * cos(angle),
                     (distance - radius) * (distance + radius)}};
}

// The law of scale: with everything k times as large a, b and c are k^2 times as large.
START_TEST(an_equation_may_be_of_any_size)
{
    enum { COUNT = 25 };
    for (int i = 0; i < COUNT; i++) {
        Angled it = random_angled(random_scale(i, COUNT));
        given_object_ray(it.ray, it.radius);
        expect_quadratic_of_size(object_quadratic(it.ray, it.radius), it.quadratic.a,
                                 it.quadratic.b, it.quadratic.c, it.size);
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
        Ray ray = random_ray(5, 2);
        Sphere sphere = random_sphere(5, 0.1, 5);
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

START_TEST(an_equation_of_the_world_may_be_of_any_size)
{
    enum { COUNT = 25 };
    for (int i = 0; i < COUNT; i++) {
        double world = random_scale(i, COUNT);
        Angled it = random_angled(world);
        Sphere sphere = {.center = world * random_vec3(-5, 5), .radius = it.radius};
        it.ray.origin += sphere.center;
        given_ray_and_sphere(it.ray, sphere);
        expect_quadratic_of_size(world_quadratic(it.ray, sphere), it.quadratic.a, it.quadratic.b,
                                 it.quadratic.c, it.size + vec3_length(sphere.center));
    }
}
END_TEST

void list_tests_of_coefficients(void)
{
    tests_of("to_object_coordinates");
    test(the_origin_is_seen_from_the_centre_of_the_sphere);
    test(the_direction_stays_as_it_is);
    test(a_place_that_was_chosen_round_the_centre_comes_back);
    test(worlds_and_directions_may_be_of_any_size);
    tests_of("object_quadratic");
    test(the_equation_of_the_arrow_of_the_deck);
    test(the_equation_of_the_ray_through_the_hits_drawn_in_the_deck);
    test(a_radius_of_3_and_a_direction_of_length_3);
    test(a_direction_that_is_nearly_unit_is_not_unit);
    test(c_is_negative_for_a_ray_that_begins_inside);
    test(at_every_t_it_is_the_squared_distance_less_the_squared_radius);
    test(an_equation_may_be_of_any_size);
    tests_of("world_quadratic");
    test(a_sphere_at_the_origin_of_the_world_gives_what_object_coordinates_give);
    test(a_sphere_off_the_origin_of_the_world);
    test(moving_the_eye_and_the_sphere_together_changes_nothing);
    test(in_the_world_too_it_is_the_squared_distance_less_the_squared_radius);
    test(an_equation_of_the_world_may_be_of_any_size);
}
