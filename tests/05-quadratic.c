// 05-quadratic.c - tests of exercise 05. Expected values: the lecture's example and the deck's
// section, chords worked out by hand, and what is true of any ray and sphere that were constructed
// from their hits.
#include "exercises/05-quadratic.h"

#include "chapters/shared/example.h"
#include "tests/judge/test.h"

#include <stdlib.h>

#define TOLERANCE 1e-9
#define ROOT_TOLERANCE 1e-6 // of the radius, along the ray

static Sphere sphere_at(double x, double y, double z, double radius)
{
    return (Sphere){.center = vec3_of(x, y, z), .radius = radius};
}

// A random sphere, and a ray that was constructed backwards: from a point on the sphere outwards to
// the origin. cosine is that of the angle to the surface's normal there, so that the chord inside
// the sphere is 2 r cosine.
typedef struct {
    Ray ray;
    Sphere sphere;
    double near, far; // the t of both hits
} Aimed;

// ---- descriptions ------------------------------------------------------------------------------

// The arguments, and the expected results. Tolerances are absolute.
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

// a, b, c are sums of products of two of the arguments; size is how large the arguments are.
static void expect_quadratic(Quadratic yours, Quadratic expected, double size)
{
    given("in order", "a, b, c");
    expect_vec3(vec3_of(yours.a, yours.b, yours.c), vec3_of(expected.a, expected.b, expected.c),
                TOLERANCE * size * size);
}

static void given_object_ray(Ray ray, double radius)
{
    given_ray(ray);
    given_number("radius", radius);
}

static void expect_object_quadratic(Ray ray, double radius, Quadratic expected, double size)
{
    given_object_ray(ray, radius);
    expect_quadratic(object_quadratic(ray, radius), expected, size);
}

static void expect_world_quadratic(Ray ray, Sphere sphere, Quadratic expected, double size)
{
    given_ray_and_sphere(ray, sphere);
    expect_quadratic(world_quadratic(ray, sphere), expected, size);
}

static void expect_roots_of(Quadratic q, Roots expected, double within)
{
    given_quadratic(q);
    expect_roots(quadratic_roots(q), expected, within);
}

static void expect_meetings(Ray ray, Sphere sphere, Roots expected, double within)
{
    given_ray_and_sphere(ray, sphere);
    expect_roots(sphere_roots(ray, sphere), expected, within);
}

static const Roots no_roots = {0};

static Roots two(double t, double u)
{
    return (Roots){2, {t, u}};
}

// ---- rays and spheres --------------------------------------------------------------------------

// The deck's section: the circle of radius 1 around the origin, seen from (-4, -1).
static Ray ray_of_the_deck(double x, double y)
{
    return (Ray){vec3_of(-4, -1, 0), vec3_of(x, y, 0)};
}

static Sphere unit_sphere(void)
{
    return (Sphere){.center = vec3_of(0, 0, 0), .radius = 1};
}

static Aimed random_aimed(double radii_away)
{
    Aimed aimed;
    aimed.sphere = random_sphere(5, 0.1, 3);
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

// Rays from inside a random sphere, with the near hit behind; away from one, with both behind; and
// past one, with neither.
static Aimed random_inside(void)
{
    for (;;) {
        Aimed aimed = random_aimed(-random_number(0.05, 1.9));
        double to_exit = aimed.far * vec3_length(aimed.ray.direction) / aimed.sphere.radius;
        if (to_exit > 0.05)
            return aimed;
    }
}

static Aimed random_behind(void)
{
    return random_aimed(-random_number(2.1, 100));
}

// From a point beside the sphere, where the ray is at right angles to its radius.
static Aimed random_beside(void)
{
    Aimed aimed = {.sphere = random_sphere(5, 0.1, 3), .near = NO_HIT, .far = NO_HIT};
    vec3 direction = random_unit(), aside = vec3_unit(vec3_cross(direction, random_unit()));
    double r = aimed.sphere.radius, away = random_number(-100, 100) * r;
    vec3 passed = aimed.sphere.center + random_number(1.05, 3) * r * aside;
    aimed.ray = (Ray){passed - away * direction, random_number(0.1, 10) * direction};
    return aimed;
}

// The same with everything in the world multiplied by one factor, and the direction by another.
static Aimed scaled(Aimed aimed, double world, double length)
{
    aimed.ray.origin *= world;
    aimed.ray.direction *= length;
    aimed.sphere.center *= world;
    aimed.sphere.radius *= world;
    if (aimed.near < NO_HIT) {
        aimed.near *= world / length;
        aimed.far *= world / length;
    }
    return aimed;
}

// ---- to_object_coordinates ----------------------------------------------------------------------

TEST(to_object_coordinates, the_origin_is_seen_from_the_center_of_the_sphere)
{
    Ray ray = {vec3_of(1, 2, 3), vec3_of(0, 0, -1)};
    Sphere sphere = sphere_at(4, -1, 1, 2);
    given_ray_and_sphere(ray, sphere);
    given("looking at", "the origin");
    expect_vec3(to_object_coordinates(ray, sphere).origin, vec3_of(-3, 3, 2), TOLERANCE);
}

TEST(to_object_coordinates, the_direction_stays_as_it_is)
{
    Ray ray = {vec3_of(1, 2, 3), vec3_of(2, -3, 6)};
    Sphere sphere = sphere_at(4, -1, 1, 2);
    given_ray_and_sphere(ray, sphere);
    given("looking at", "the direction");
    expect_vec3(to_object_coordinates(ray, sphere).direction, vec3_of(2, -3, 6), TOLERANCE);
}

// From a random place around a sphere, in a world of that size, along a direction of that length.
TEST(to_object_coordinates, worlds_and_directions_may_be_of_any_size)
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

// ---- object_quadratic ---------------------------------------------------------------------------

// The numbers of the deck's arrow: 0.89^2 + 0.45^2, 2 (-4 * 0.89 - 0.45), 16 + 1 - 1.
TEST(object_quadratic, the_equation_of_the_ray_of_the_example)
{
    Ray ray = example_ray();
    Sphere sphere = example_sphere();
    Quadratic q = {0, 0, -sphere.radius * sphere.radius};
    double size = 1;
    for (int i = 0; i < 3; i++) {
        ray.origin[i] -= sphere.center[i];
        q.a += ray.direction[i] * ray.direction[i];
        q.b += 2 * ray.origin[i] * ray.direction[i];
        q.c += ray.origin[i] * ray.origin[i];
        size = fmax(size, fmax(fabs(ray.origin[i]), fabs(ray.direction[i])));
    }
    expect_object_quadratic(ray, sphere.radius, q, size);
}

// By hand: 4 + 1 + 4, 2 (2 - 2 - 6), 1 + 4 + 9 - 9.
TEST(object_quadratic, a_radius_of_3_and_a_direction_of_length_3)
{
    Ray ray = {vec3_of(1, -2, 3), vec3_of(2, 1, -2)};
    expect_object_quadratic(ray, 3, (Quadratic){9, -12, 5}, 1);
}

TEST(object_quadratic, c_is_negative_for_a_ray_that_starts_inside)
{
    Ray ray = {vec3_of(0, 0, 1), vec3_of(0, 0, 2)};
    expect_object_quadratic(ray, 4, (Quadratic){4, 4, -15}, 1);
}

// The meaning of the equation: at every t, the point's squared distance from the center minus the
// squared radius.
static void expect_value_at(double t, Quadratic q, Ray ray, Sphere sphere)
{
    double distance = vec3_length(ray.origin + t * ray.direction - sphere.center);
    expect_number(q.a * t * t + q.b * t + q.c,
                  (distance - sphere.radius) * (distance + sphere.radius), 1e-6);
}

static void looking_at_value(double t)
{
    given("looking at", "a t^2 + b t + c for t = %s", number_text_to(t, 10).s);
}

TEST(object_quadratic, at_every_t_it_is_the_squared_distance_minus_the_squared_radius)
{
    for (int i = 0; i < 30; i++) {
        Ray ray = random_ray(5, 2);
        double radius = random_number(0.1, 5), t = random_number(-3, 3);
        given_object_ray(ray, radius);
        looking_at_value(t);
        expect_value_at(t, object_quadratic(ray, radius), ray, sphere_at(0, 0, 0, radius));
    }
}

// A ray whose angle to the line from its origin to the center is known, in a world of any size; the
// direction is a little longer or shorter than the size of that world. size: of the arguments.
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

// The law of scale: with everything k times as large, a, b and c are k^2 times as large.
TEST(object_quadratic, an_equation_may_be_of_any_size)
{
    enum { COUNT = 25 };
    for (int i = 0; i < COUNT; i++) {
        Angled it = random_angled(random_scale(i, COUNT));
        expect_object_quadratic(it.ray, it.radius, it.quadratic, it.size);
    }
}

// ---- world_quadratic ----------------------------------------------------------------------------

// From the center the origin is (1, -2, 3), as in the test of object coordinates.
TEST(world_quadratic, a_sphere_off_the_origin_of_the_world)
{
    Ray ray = {vec3_of(1, 2, 3), vec3_of(2, 1, -2)};
    Sphere sphere = sphere_at(0, 4, 0, 3);
    expect_world_quadratic(ray, sphere, (Quadratic){9, -12, 5}, 1);
}

TEST(world_quadratic, in_the_world_it_is_also_the_squared_distance_minus_the_squared_radius)
{
    for (int i = 0; i < 30; i++) {
        Ray ray = random_ray(5, 2);
        Sphere sphere = random_sphere(5, 0.1, 5);
        double t = random_number(-3, 3);
        given_ray_and_sphere(ray, sphere);
        looking_at_value(t);
        expect_value_at(t, world_quadratic(ray, sphere), ray, sphere);
    }
}

TEST(world_quadratic, an_equation_of_the_world_may_be_of_any_size)
{
    enum { COUNT = 25 };
    for (int i = 0; i < COUNT; i++) {
        double world = random_scale(i, COUNT);
        Angled it = random_angled(world);
        Sphere sphere = {.center = world * random_vec3(-5, 5), .radius = it.radius};
        it.ray.origin += sphere.center;
        expect_world_quadratic(it.ray, sphere, it.quadratic, it.size + vec3_length(sphere.center));
    }
}

// ---- quadratic_roots ---------------------------------------------------------------------------

// The quadratic with these roots.
static Quadratic with_roots(double a, double t, double u)
{
    return (Quadratic){a, -a * (t + u), a * t * u};
}

// By hand: (9 - 1) / 2.5 and (9 + 1) / 2.5.
TEST(quadratic_roots, the_roots_are_the_t_of_the_hits_drawn_in_the_deck)
{
    expect_roots_of((Quadratic){1.25, -9, 16}, two(3.2, 4), TOLERANCE);
}

TEST(quadratic_roots, the_roots_of_the_arrow_of_the_deck)
{
    expect_roots_of((Quadratic){0.9946, -8.02, 16}, two(3.622, 4.442), 1e-3);
}

TEST(quadratic_roots, chosen_roots_are_found_again)
{
    expect_roots_of(with_roots(1, 2, 3), two(2, 3), TOLERANCE);
    expect_roots_of(with_roots(2, -1, 5), two(-1, 5), TOLERANCE);
    expect_roots_of(with_roots(0.5, -6, -4), two(-6, -4), TOLERANCE);
    expect_roots_of(with_roots(0.25, -5, 2), two(-5, 2), TOLERANCE);
    for (int i = 0; i < 30; i++) {
        double a = random_number(0.1, 5), t = random_number(-9, 9), gap = random_number(0.1, 9);
        expect_roots_of(with_roots(a, t, t + gap), two(t, t + gap), TOLERANCE);
    }
}

TEST(quadratic_roots, roots_come_in_ascending_order_even_when_a_is_negative)
{
    expect_roots_of(with_roots(-1, 2, 3), two(2, 3), TOLERANCE);
    expect_roots_of(with_roots(-4, -7, 1), two(-7, 1), TOLERANCE);
    for (int i = 0; i < 10; i++) {
        double a = -random_number(0.1, 5), t = random_number(-9, 9), gap = random_number(0.1, 9);
        expect_roots_of(with_roots(a, t, t + gap), two(t, t + gap), TOLERANCE);
    }
}

// a and the root are powers of two, and so are b and c: nothing is rounded, even by an answer that
// divides by one of them first.
TEST(quadratic_roots, a_double_root_counts_as_two)
{
    expect_roots_of((Quadratic){1, -8, 16}, two(4, 4), TOLERANCE);
    expect_roots_of((Quadratic){2, 8, 8}, two(-2, -2), TOLERANCE);
    expect_roots_of((Quadratic){3, 0, 0}, two(0, 0), TOLERANCE);
    for (int i = 0; i < 10; i++) {
        double a = ldexp(i % 2 == 0 ? 1 : -1, (int)random_number(-10, 10));
        double t = ldexp(i % 4 < 2 ? 1 : -1, (int)random_number(-10, 10));
        expect_roots_of(with_roots(a, t, t), two(t, t), TOLERANCE);
    }
}

TEST(quadratic_roots, a_parabola_that_stays_on_one_side_has_no_roots)
{
    Quadratic none[] = {{1, 0, 1}, {2, -4, 9}, {1, 1, 0.5}, {-1, 2, -5}};
    for (int i = 0; i < 4; i++)
        expect_roots_of(none[i], no_roots, 0);
    // a ((t - lowest)^2 + above^2)
    for (int i = 0; i < 10; i++) {
        double a = random_number(0.1, 5) * (i % 2 == 0 ? 1 : -1);
        double lowest = random_number(-9, 9), above = random_number(0.1, 3);
        expect_roots_of((Quadratic){a, -2 * a * lowest, a * (lowest * lowest + above * above)},
                        no_roots, 0);
    }
}

TEST(quadratic_roots, if_c_is_0_one_root_is_0)
{
    expect_roots_of((Quadratic){2, -6, 0}, two(0, 3), TOLERANCE);
    expect_roots_of((Quadratic){2, 6, 0}, two(-3, 0), TOLERANCE);
    expect_roots_of((Quadratic){3e6, -6e6, 0}, two(0, 2), TOLERANCE);
    expect_roots_of((Quadratic){-3e6, 6e6, 0}, two(0, 2), TOLERANCE);
}

TEST(quadratic_roots, if_a_is_0_it_is_a_line_with_one_root)
{
    expect_roots_of((Quadratic){0, 2, -6}, (Roots){1, {3}}, TOLERANCE);
    expect_roots_of((Quadratic){0, -4, 0}, (Roots){1, {0}}, TOLERANCE);
    for (int i = 0; i < 10; i++) {
        double b = random_number(0.1, 5) * (i % 2 == 0 ? 1 : -1), t = random_number(-9, 9);
        expect_roots_of((Quadratic){0, b, -b * t}, (Roots){1, {t}}, TOLERANCE);
    }
}

TEST(quadratic_roots, if_a_and_b_are_0_there_are_no_roots)
{
    double c[] = {5, -5, 0, 1, -1};
    for (int i = 0; i < 5; i++)
        expect_roots_of((Quadratic){0, 0, c[i]}, no_roots, 0);
}

// The law of scale: if a, b and c are all multiplied by one number, the roots stay; and with b and
// c divided by k and its square, the roots are 1/k of what they were. No coefficient is small in
// itself.
TEST(quadratic_roots, coefficients_and_roots_may_be_large_or_small)
{
    enum { COUNT = 25 };
    for (int i = 0; i < COUNT; i++) {
        double size = random_scale(i, COUNT), bend = random_scale((7 * i) % COUNT, COUNT);
        double a = random_number(0.5, 5) * pow(bend, 3); // size may be any number compared with it
        double t = size * random_number(-9, 9), gap = size * random_number(0.1, 9);
        if (i % 5 == 4)
            a = -a;
        Quadratic above = {a, -2 * a * t, a * (t * t + gap * gap)}; // a ((x - t)^2 + gap^2)
        if (i % 3 < 2)
            expect_roots_of(with_roots(a, t, t + gap), two(t, t + gap), TOLERANCE * size);
        else
            expect_roots_of(above, no_roots, 0);
    }
}

// D is 4 times the root's square.
TEST(quadratic_roots, a_discriminant_may_be_of_any_size)
{
    for (int power = -16; power <= 16; power++) {
        double root = pow(10, power);
        expect_roots_of((Quadratic){1, 0, -root * root}, two(-root, root), TOLERANCE * root);
        expect_roots_of((Quadratic){1, 0, root * root}, no_roots, 0);
    }
}

TEST(quadratic_roots, a_line_may_be_steep_or_almost_level)
{
    enum { COUNT = 13 };
    for (int i = 0; i < COUNT; i++) {
        double slope = pow(random_scale(i, COUNT), 3);
        double b = random_number(0.5, 5) * slope * (i % 2 == 0 ? 1 : -1);
        double size = random_scale((5 * i) % COUNT, COUNT), t = size * random_number(-9, 9);
        expect_roots_of((Quadratic){0, b, -b * t}, (Roots){1, {t}}, TOLERANCE * size);
    }
}

// ---- sphere_roots: where a whole line meets a sphere -------------------------------------------

static void expect_aimed(Aimed aimed)
{
    given("known", "the angle at the surface");
    expect_meetings(aimed.ray, aimed.sphere, two(aimed.near, aimed.far),
                    ROOT_TOLERANCE * aimed.sphere.radius / vec3_length(aimed.ray.direction));
}

TEST_LINE(sphere_roots, the_line_drawn_in_the_deck_meets_the_sphere_in_the_hits_drawn,
          expect_meetings(ray_of_the_deck(1, 0.5), unit_sphere(), two(3.2, 4), ROOT_TOLERANCE))

TEST(sphere_roots, a_sphere_away_from_the_origin_is_met_at_the_same_t)
{
    Ray ray = {vec3_of(3, 8, -2), vec3_of(1, 0.5, 0)};
    expect_meetings(ray, sphere_at(7, 9, -2, 1), two(3.2, 4), ROOT_TOLERANCE);
}

TEST(sphere_roots, a_sphere_behind_the_origin_is_also_met)
{
    expect_meetings(ray_of_the_deck(-1, -0.5), unit_sphere(), two(-4, -3.2), ROOT_TOLERANCE);
    for (int i = 0; i < 10; i++)
        expect_aimed(i % 2 == 0 ? random_behind() : random_inside());
}

TEST(sphere_roots, a_tangent_line_meets_a_sphere_twice_at_one_point)
{
    // As for hit_sphere: nothing is rounded, whichever of the usual formulas is used.
    Ray ray = {vec3_of(-4, 3, 0), vec3_of(1, 0, 0)};
    expect_meetings(ray, sphere_at(0, 0, 0, 3), two(4, 4), ROOT_TOLERANCE * 3);
    ray = (Ray){vec3_of(2, 5, -1), vec3_of(0, 0, 2)};
    expect_meetings(ray, sphere_at(2, 1, 2, 4), two(1.5, 1.5), ROOT_TOLERANCE * 2);
}

TEST(sphere_roots, a_line_that_touches_a_sphere_at_its_start_meets_it_at_0)
{
    Ray ray = {vec3_of(3, 5, 0), vec3_of(0, 0, 2)};
    expect_meetings(ray, sphere_at(3, 4, 0, 1), two(0, 0), ROOT_TOLERANCE);
}

TEST(sphere_roots, a_line_that_passes_beside_a_sphere_does_not_meet_it)
{
    Ray ray = {vec3_of(-4, 1.25, 0), vec3_of(1, 0, 0)};
    expect_meetings(ray, unit_sphere(), no_roots, 0);
    ray = ray_of_the_deck(1, -0.5);
    expect_meetings(ray, unit_sphere(), no_roots, 0);
    for (int i = 0; i < 10; i++) {
        Aimed past = random_beside();
        expect_meetings(past.ray, past.sphere, no_roots, 0);
    }
}

// 3 away, with a radius of 2: 1 and 5 to go, with a direction that gets longer or shorter each
// time.
TEST(sphere_roots, both_t_may_be_of_any_size)
{
    for (int power = -16; power <= 16; power++) {
        double length = pow(10, power);
        Ray ray = {vec3_of(0, 1, 0), vec3_of(length, 0, 0)};
        expect_meetings(ray, sphere_at(3, 1, 0, 2), two(1 / length, 5 / length),
                        ROOT_TOLERANCE / length);
    }
}

// First a tiny world and a long direction, last the reverse: from outside, from inside, with the
// sphere behind, and past it.
static Aimed in_any_world(int i, int count)
{
    Aimed aimed = i % 4 == 0   ? random_aimed(random_number(1, 10))
                  : i % 4 == 1 ? random_inside()
                  : i % 4 == 2 ? random_behind()
                               : random_beside();
    double world = pow(random_scale(i, count), 1.5);
    return scaled(aimed, world, random_scale(i % 2 == 0 ? count - 1 - i : i, count));
}

TEST(sphere_roots, spheres_are_met_at_the_right_t_in_any_world_and_along_any_direction)
{
    enum { COUNT = 25 };
    for (int i = 0; i < COUNT; i++) {
        Aimed aimed = in_any_world(i, COUNT);
        if (i % 4 < 3)
            expect_aimed(aimed);
        else
            expect_meetings(aimed.ray, aimed.sphere, no_roots, 0);
    }
}

// ---- hit_sphere: the place that is seen --------------------------------------------------------

static void expect_hit(Ray ray, Sphere sphere, double t)
{
    given_ray_and_sphere(ray, sphere);
    expect_number(hit_sphere(ray, sphere), t,
                  ROOT_TOLERANCE * sphere.radius / vec3_length(ray.direction));
}

TEST(hit_sphere, the_arrow_of_the_deck_hits_the_near_side_of_the_sphere)
{
    given_ray_and_sphere(ray_of_the_deck(0.89, 0.45), unit_sphere());
    expect_number(hit_sphere(ray_of_the_deck(0.89, 0.45), unit_sphere()), 3.622, 1e-3);
}

// By geometry: half a chord before the place of the line that is nearest to the center.
TEST(hit_sphere, the_ray_of_the_example_hits_the_near_side_of_the_sphere)
{
    Ray ray = example_ray();
    Sphere sphere = example_sphere();
    double length = vec3_length(ray.direction);
    vec3 to_center = sphere.center - ray.origin, unit = ray.direction / length;
    double middle = vec3_dot(to_center, unit), away = vec3_length(to_center - middle * unit);
    double half = sqrt((sphere.radius - away) * (sphere.radius + away));
    expect_hit(ray, sphere, (middle - half) / length);
}

TEST(hit_sphere, from_outside_the_nearer_of_two_points_is_hit)
{
    expect_hit(ray_of_the_deck(1, 0.5), unit_sphere(), 3.2);
    Ray ray = {vec3_of(3, 8, -2), vec3_of(1, 0.5, 0)};
    expect_hit(ray, sphere_at(7, 9, -2, 1), 3.2);
}

// 10 away, radius 2: 8 to go.
TEST(hit_sphere, t_counts_in_lengths_of_the_direction)
{
    double length[] = {1, 2, 16, 0.25};
    for (int i = 0; i < 4; i++) {
        Ray ray = {vec3_of(1, 1, 5), vec3_of(0, 0, -length[i])};
        expect_hit(ray, sphere_at(1, 1, -5, 2), 8 / length[i]);
    }
}

TEST(hit_sphere, from_inside_the_exit_is_hit)
{
    Ray ray = {vec3_of(1, 1, 2), vec3_of(0, 0, 2)};
    expect_hit(ray, sphere_at(1, 1, 1, 3), 1);
    ray.direction = vec3_of(0, 0, -2);
    expect_hit(ray, sphere_at(1, 1, 1, 3), 2);
    ray.origin = vec3_of(0, 0, 0); // the center
    expect_hit(ray, unit_sphere(), 0.5);
    for (int i = 0; i < 10; i++) {
        Aimed inside = random_inside();
        expect_hit(inside.ray, inside.sphere, inside.far);
    }
}

TEST(hit_sphere, a_sphere_behind_the_eye_is_not_hit)
{
    expect_hit(ray_of_the_deck(-1, -0.5), unit_sphere(), NO_HIT);
    for (int i = 0; i < 10; i++) {
        Aimed behind = random_behind();
        expect_hit(behind.ray, behind.sphere, NO_HIT);
    }
}

TEST(hit_sphere, a_sphere_beside_the_ray_is_not_hit)
{
    Ray ray = {vec3_of(-4, 1.25, 0), vec3_of(1, 0, 0)};
    expect_hit(ray, unit_sphere(), NO_HIT);
    for (int i = 0; i < 10; i++) {
        Aimed past = random_beside();
        expect_hit(past.ray, past.sphere, NO_HIT);
    }
}

// Only rays along an axis, 1 or 2 long, and whole numbers: a triangle with sides 3 and 4 has the
// diagonal 5. So nothing is rounded, whichever of the usual formulas is used, and every right
// answer hits.
TEST(hit_sphere, a_tangent_ray_hits)
{
    Ray ray = {vec3_of(-4, 3, 0), vec3_of(1, 0, 0)};
    expect_hit(ray, sphere_at(0, 0, 0, 3), 4);
    ray = (Ray){vec3_of(2, 10, -3), vec3_of(0, -2, 0)};
    expect_hit(ray, sphere_at(5, 6, -3, 3), 2);
    ray = (Ray){vec3_of(2, 5, -1), vec3_of(0, 0, 2)};
    expect_hit(ray, sphere_at(2, 1, 2, 4), 1.5);
}

// On the surface in the direction of an axis, for the same reason.
TEST(hit_sphere, from_the_surface_inward_the_far_side_is_hit)
{
    Ray ray = {vec3_of(0, 0, 5), vec3_of(0, 0, -2)};
    expect_hit(ray, sphere_at(0, 0, 2, 3), 3);
    ray = (Ray){vec3_of(-2, 3, 6), vec3_of(1, 0, 0)};
    expect_hit(ray, sphere_at(1, 3, 6, 3), 6);
}

TEST(hit_sphere, from_the_surface_outward_nothing_is_hit)
{
    Ray ray = {vec3_of(0, 0, 5), vec3_of(0, 0, 2)};
    expect_hit(ray, sphere_at(0, 0, 2, 3), NO_HIT);
    ray = (Ray){vec3_of(-2, 3, 6), vec3_of(-1, 0, 0)};
    expect_hit(ray, sphere_at(1, 3, 6, 3), NO_HIT);
}

TEST(hit_sphere, a_surface_close_to_the_eye_is_hit)
{
    Ray ray = {vec3_of(0, 0, -0.99), vec3_of(0, 0, -1)};
    expect_hit(ray, sphere_at(0, 0, -2, 1), 0.01);
    ray.origin = vec3_of(0, 0, -0.97);
    for (double length = 1; length < 1e17; length *= 10) {
        ray.direction = vec3_of(0, 0, -length);
        expect_hit(ray, sphere_at(0, 0, -2, 1), 0.03 / length);
    }
}

// 700 to go, with a direction that gets shorter each time.
TEST(hit_sphere, t_may_be_of_any_size)
{
    for (double length = 1; length > 1e-17; length /= 10) {
        Ray ray = {vec3_of(0, 1, 0), vec3_of(length, 0, 0)};
        expect_hit(ray, sphere_at(800, 1, 0, 100), 700 / length);
    }
}

// The law of scale: with the world k times as large t is k times as large, and with the direction k
// times as long it is 1/k of that.
TEST(hit_sphere, spheres_are_hit_at_the_right_t_in_any_world_and_along_any_direction)
{
    enum { COUNT = 25 };
    for (int i = 0; i < COUNT; i++) {
        Aimed aimed = in_any_world(i, COUNT);
        expect_hit(aimed.ray, aimed.sphere,
                   i % 4 == 0   ? aimed.near
                   : i % 4 == 1 ? aimed.far
                                : NO_HIT);
    }
}

TEST(hit_sphere, a_ray_aimed_at_a_point_on_a_sphere_hits_it)
{
    for (int i = 0; i < 50; i++) {
        Aimed aimed = random_aimed(random_number(0.1, 1000));
        given("known", "the point of the hit");
        expect_hit(aimed.ray, aimed.sphere, aimed.near);
    }
}

// ---- quadratic_roots beyond the slide's formula ------------------------------------------------

// The formula loses digits. These tests cost no marks.

// t^2 - 10^8 t + 1: the product of the roots is 1, their sum 10^8; so 10^-8 to 16 digits.
EXTRA_TEST(quadratic_roots, a_small_root_beside_a_large_one_keeps_its_digits)
{
    given_quadratic((Quadratic){1, -1e8, 1});
    expect_number(quadratic_roots((Quadratic){1, -1e8, 1}).t[0], 1e-8, 1e-17);
    given_quadratic((Quadratic){1, 1e8, 1});
    expect_number(quadratic_roots((Quadratic){1, 1e8, 1}).t[1], -1e-8, 1e-17);
}

// Kahan's example: a + b + c is exactly 0, so 1 is a root, and the other is c / a. Then the same
// with t counted in two thirds, so that a and c are far apart.
EXTRA_TEST(quadratic_roots, roots_that_are_nearly_equal_keep_their_digits)
{
    const double a = 94906265.625, b = -189812534, c = 94906268.375;
    expect_roots_of((Quadratic){a, b, c}, two(1, c / a), 1e-12);
    expect_roots_of((Quadratic){2.25 * a, 1.5 * b, c}, two(1 / 1.5, c / a / 1.5), 1e-12);
}

// Last 1.25 (t - 1.5)(t - 3), times a power of two, for t times a power of two.
EXTRA_TEST(quadratic_roots, coefficients_and_roots_may_be_of_any_size)
{
    expect_roots_of((Quadratic){1e200, -3e200, 2e200}, two(1, 2), TOLERANCE);
    expect_roots_of((Quadratic){1e-200, -3e-200, 2e-200}, two(1, 2), TOLERANCE);
    for (int size = -900; size <= 900; size += 300)
        for (int t = -400; t <= 400; t += 100)
            if (abs(size + 2 * t) < 1000)
                expect_roots_of((Quadratic){ldexp(1.25, size), ldexp(-5.625, size + t),
                                            ldexp(5.625, size + 2 * t)},
                                two(ldexp(1.5, t), ldexp(3, t)), ldexp(1e-12, t));
}

EXTRA_TEST(quadratic_roots, if_b_is_0_or_almost_0_coefficients_may_be_of_any_size)
{
    expect_roots_of((Quadratic){0x1p600, 0, -0x1p-600}, two(-0x1p-600, 0x1p-600), 0x1p-640);
    expect_roots_of((Quadratic){0x1p-600, 0, -0x1p600}, two(-0x1p600, 0x1p600), 0x1p560);
    expect_roots_of((Quadratic){0x1p600, 0x1p-1000, -0x1p-600}, two(-0x1p-600, 0x1p-600), 0x1p-640);
    expect_roots_of((Quadratic){0x1p600, 0, -0x1p600}, two(-1, 1), 1e-12);
    expect_roots_of((Quadratic){0x1p-600, 0, -0x1p-600}, two(-1, 1), 1e-12);
    expect_roots_of((Quadratic){0x1p-600, 0, 0x1p-600}, no_roots, 0);
}

EXTRA_TEST(quadratic_roots, if_c_is_0_coefficients_may_be_of_any_size)
{
    expect_roots_of((Quadratic){0x1p500, -0x3p-300, 0}, two(0, 0x3p-800), 0x1p-840);
    expect_roots_of((Quadratic){0x1p-100, -0x3p-700, 0}, two(0, 0x3p-600), 0x1p-640);
    expect_roots_of((Quadratic){0x1p-100, -0x3p700, 0}, two(0, 0x3p800), 0x1p760);
}

// Then the roots are -c / b and -b / a to the last digit.
EXTRA_TEST(quadratic_roots, b_may_be_far_larger_than_the_others)
{
    expect_roots_of((Quadratic){1, -0x1p400, 0}, two(0, 0x1p400), 0x1p360);
    Quadratic q = {0x1p-300, -0x1p100, -0x1p-50};
    given_quadratic(q);
    given("looking at", "the first root");
    expect_number(quadratic_roots(q).t[0], -0x1p-150, 0x1p-190);
    given_quadratic(q);
    given("looking at", "the second root");
    expect_number(quadratic_roots(q).t[1], 0x1p400, 0x1p360);
}

EXTRA_TEST(quadratic_roots, nan_has_no_roots)
{
    const double none[] = {NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 9; i++) {
        double q[] = {1, -3, 2};
        q[i / 3] = none[i % 3];
        expect_roots_of((Quadratic){q[0], q[1], q[2]}, no_roots, 0);
    }
}

// ---- sphere_roots beyond the slide's formula ---------------------------------------------------

// Far away, enormous, tiny. These tests cost no marks.

// (2, 3, 6) and (3, -6, 2) are at right angles and 7 long. With the ray from the origin along the
// first, and a center some multiples of it ahead and some multiples of the other to the side, every
// number is whole: chords come from right-angled triangles with whole sides.
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
EXTRA_TEST(sphere_roots, a_small_sphere_far_away_is_met_at_the_right_t)
{
    double ahead[] = {1234567, 7654321, 12345679, 98765431};
    for (int i = 0; i < 4; i++)
        expect_meetings(whole_ray(), whole_sphere(ahead[i], 3, 5), two(ahead[i] - 4, ahead[i] + 4),
                        ROOT_TOLERANCE * 5);
}

EXTRA_TEST(sphere_roots, a_small_sphere_is_hit_or_missed_by_little_also_far_away)
{
    // A ten millionth of the radius; close to the eye, less than a millionth of that.
    const double ahead[] = {1234567, 2345677, 3456789, 7654321, 9876543, 10, 11};
    for (int i = 0; i < 7; i++) {
        const double little = ahead[i] < 100 ? 1e-13 : 1e-7;
        expect_meetings(whole_ray(), whole_sphere(ahead[i], 5, 5 * (1 - little)), no_roots, 0);
        given_ray_and_sphere(whole_ray(), whole_sphere(ahead[i], 5, 5 * (1 + little)));
        given("looking at", "the number of roots");
        expect_int(sphere_roots(whole_ray(), whole_sphere(ahead[i], 5, 5 * (1 + little))).count, 2);
    }
}

// The triangle 2002000, 2001, 2002001: half the chord is a thousandth of the radius.
EXTRA_TEST(sphere_roots, a_grazing_ray_keeps_its_short_chord)
{
    double ahead[] = {1234567891, 3141592653};
    for (int i = 0; i < 2; i++)
        expect_meetings(whole_ray(), whole_sphere(ahead[i], 2002000, 2002001),
                        two(ahead[i] - 2001, ahead[i] + 2001), ROOT_TOLERANCE * 2001);
}

// Whichever component of the direction is longest, and whatever its sign.
EXTRA_TEST(sphere_roots, directions_of_any_length_may_point_anywhere)
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

// The product of origin and direction has no unusual size here; the direction has.
EXTRA_TEST(sphere_roots, a_long_direction_from_near_the_origin_of_the_world)
{
    Ray ray = {vec3_of(1e-200, 1e-200, 1e-200), 1e200 * vec3_of(2, 3, 6)};
    expect_meetings(ray, whole_sphere(10, 3, 5), two(6e-200, 14e-200), 1e-209);
}

// The world's size and the direction's: each of the first two would be fine alone; together their
// squares leave the range of a double.
EXTRA_TEST(sphere_roots, world_and_direction_may_both_be_large_or_small)
{
    const double sizes[][2] = {{1e100, 1e100}, {1e-100, 1e-100}, {1e200, 1}, {1e-200, 1}};
    for (int i = 0; i < 4; i++) {
        double world = sizes[i][0], length = sizes[i][1], t = world / length;
        Ray ray = {vec3_of(0, 0, 0), length * vec3_of(2, 3, 6)};
        Sphere sphere = whole_sphere(10, 3, 5);
        sphere.center = sphere.center * world;
        sphere.radius *= world;
        expect_meetings(ray, sphere, two(6 * t, 14 * t), TOLERANCE * t);
    }
}

EXTRA_TEST(sphere_roots, an_enormous_sphere_is_met_from_its_center)
{
    Ray ray = {vec3_of(1, 2, 3), vec3_of(1, 0, 0)};
    expect_meetings(ray, sphere_at(1, 2, 3, 1e200), two(-1e200, 1e200), 1e190);
}

EXTRA_TEST(sphere_roots, a_sphere_straight_ahead_is_met_however_far_it_is)
{
    Ray ray = {vec3_of(0, 0, 0), vec3_of(1, 0, 0)};
    expect_meetings(ray, sphere_at(1e200, 0, 0, 1), two(1e200, 1e200), 1e190);
}

EXTRA_TEST(sphere_roots, nan_meets_nothing)
{
    const double none[] = {NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 9; i++) {
        Ray ray = ray_of_the_deck(1, 0.5);
        Sphere sphere = unit_sphere();
        vec3 *part[] = {&ray.origin, &ray.direction, &sphere.center};
        (*part[i / 3])[i % 2] = none[i % 3];
        expect_meetings(ray, sphere, no_roots, 0);
    }
}

// The two are 3 * 10^308 apart, which is more than a double can hold.
EXTRA_TEST(sphere_roots, a_ray_may_cross_the_whole_range_of_a_double)
{
    Ray ray = {vec3_of(-1.5e308, 0, 0), vec3_of(4, 0, 0)};
    expect_meetings(ray, sphere_at(1.5e308, 0, 0, 1e308), two(0.5e308, 1e308), 1e300);
}

// Straight down from a millionth (2^-20) above a huge sphere, and from below. 1234567 + 2^-20 is a
// double; its square is not.
EXTRA_TEST(sphere_roots, next_to_a_huge_sphere_a_short_distance_keeps_its_digits)
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

// ---- probes -------------------------------------------------------------------------------------

// Calls that distinguish the mistakes of exercise 05: from outside, from inside, past the sphere
// and away from it; p.v of either sign, near and far, short and long directions.

enum { MANY = 64 };

// From 1e-7 to 1, small as often as large, so that every threshold is between two of them.
static double any_small(void)
{
    return pow(10, random_number(-7, 0));
}

static Aimed any(int i)
{
    if (i % 8 == 6) { // close to the surface
        Aimed aimed = random_aimed(1);
        vec3 point = aimed.ray.origin + aimed.near * aimed.ray.direction;
        aimed.ray.origin = point - any_small() * aimed.ray.direction;
        return aimed;
    }
    if (i % 4 == 1)
        return random_inside();
    if (i % 4 == 2)
        return random_behind();
    if (i % 4 == 3 && i % 8 == 3)
        return random_beside();
    return random_aimed(random_number(0.05, i % 8 == 0 ? 0.5 : 20));
}

PROBE(to_object_coordinates, any_ray_in_object_coordinates)
{
    for (int i = 0; i < MANY / 2; i++) {
        Aimed it = any(i);
        to_object_coordinates(it.ray, it.sphere);
    }
}

PROBE(object_quadratic, coefficients_of_any_ray)
{
    for (int i = 0; i < MANY / 2; i++) {
        Aimed it = any(i);
        it.ray.origin -= it.sphere.center;
        object_quadratic(it.ray, it.sphere.radius);
    }
}

PROBE(world_quadratic, coefficients_of_any_ray_and_sphere)
{
    for (int i = 0; i < MANY / 2; i++) {
        Aimed it = any(i);
        world_quadratic(it.ray, it.sphere);
    }
}

// Two roots of any signs, none, and lines.
PROBE(quadratic_roots, roots_of_any_quadratic)
{
    for (int i = 0; i < MANY; i++) {
        double a = random_number(-3, 3), t = random_number(-6, 6), u = random_number(-6, 6);
        Quadratic q = {a, -a * (t + u), a * t * u};
        if (i % 4 == 1)
            q.c = (a < 0 ? -1 : 1) * random_number(0.1, 5) + q.b * q.b / (4 * a);
        if (i % 8 == 3)
            q = (Quadratic){0, i % 16 == 3 ? 0 : any_small() * q.b, q.c};
        if (i % 8 == 5)
            q = (Quadratic){a * random_number(0.001, 1), q.b, q.c};
        if (i % 8 == 7)
            q = (Quadratic){a, 0, -a * t * t};
        quadratic_roots(q);
    }
}

PROBE(sphere_roots, roots_of_any_ray_and_sphere)
{
    for (int i = 0; i < MANY; i++) {
        Aimed it = any(i);
        if (i % 4 >= 2) // worlds and directions of any size
            it = scaled(it, pow(10, random_number(-6, 6)), pow(10, random_number(-6, 6)));
        sphere_roots(it.ray, it.sphere);
    }
}

PROBE(hit_sphere, hits_of_any_ray_and_sphere)
{
    for (int i = 0; i < MANY; i++) {
        Aimed it = any(i);
        if (i / 4 % 2 == 1) // worlds and directions of any size
            it = scaled(it, pow(10, random_number(-6, 6)), pow(10, random_number(-6, 6)));
        hit_sphere(it.ray, it.sphere);
    }
}

// From close to the surface, and from inside with directions of any length, so that t is of any
// size.
PROBE(hit_sphere, hits_at_any_t)
{
    for (int i = 0; i < MANY; i++) {
        Aimed it = any(i % 2 == 0 ? 6 : 1);
        if (i % 2 == 1)
            it.ray.direction *= pow(10, random_number(-2, 2));
        hit_sphere(it.ray, it.sphere);
    }
}

// The distance back to the near place is so short that its digits are lost if roots are subtracted.
PROBE(hit_sphere, hits_from_just_below_the_surface)
{
    for (int i = 0; i < MANY / 8; i++) {
        Aimed it = random_aimed(1);
        it.ray.origin += (it.near + 1e-11) * it.ray.direction;
        hit_sphere(it.ray, it.sphere);
    }
}
