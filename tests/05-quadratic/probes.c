// probes.c - calls that distinguish the mistakes of exercise 05: from outside, from inside, past
// the sphere and away from it; p.v of either sign, near and far, short and long directions.
#include "tests/05-quadratic/support.h"

#include "tests/judge/suspects.h"

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

START_TEST(any_ray_in_object_coordinates)
{
    for (int i = 0; i < MANY / 2; i++) {
        Aimed it = any(i);
        to_object_coordinates(it.ray, it.sphere);
    }
}
END_TEST

START_TEST(coefficients_of_any_ray)
{
    for (int i = 0; i < MANY / 2; i++) {
        Aimed it = any(i);
        it.ray.origin -= it.sphere.center;
        object_quadratic(it.ray, it.sphere.radius);
    }
}
END_TEST

START_TEST(coefficients_of_any_ray_and_sphere)
{
    for (int i = 0; i < MANY / 2; i++) {
        Aimed it = any(i);
        world_quadratic(it.ray, it.sphere);
    }
}
END_TEST

// Two roots of any signs, none, and lines.
START_TEST(roots_of_any_quadratic)
{
    for (int i = 0; i < MANY; i++) {
        double a = random_number(-3, 3), t = random_number(-6, 6), u = random_number(-6, 6);
        Quadratic q = {a, -a * (t + u), a * t * u};
        if (i % 4 == 1)
            q.c = (a < 0 ? -1 : 1) * random_number(0.1, 5) + q.b * q.b / (4 * a);
        if (i % 8 == 3)
            q = (Quadratic){0, i % 16 == 3 ? 0 : any_small() * q.b, q.c};
        if (i % 8 == 5)
            q = (Quadratic){a * any_small(), q.b, q.c};
        if (i % 8 == 7)
            q = (Quadratic){a, 0, -a * t * t};
        quadratic_roots(q);
    }
}
END_TEST

START_TEST(roots_of_any_ray_and_sphere)
{
    for (int i = 0; i < MANY; i++) {
        Aimed it = any(i);
        if (i % 4 >= 2) // worlds and directions of any size
            it = scaled(it, pow(10, random_number(-6, 6)), pow(10, random_number(-6, 6)));
        sphere_roots(it.ray, it.sphere);
    }
}
END_TEST

START_TEST(hits_of_any_ray_and_sphere)
{
    for (int i = 0; i < MANY; i++) {
        Aimed it = any(i);
        if (i / 4 % 2 == 1) // worlds and directions of any size
            it = scaled(it, pow(10, random_number(-6, 6)), pow(10, random_number(-6, 6)));
        hit_sphere(it.ray, it.sphere);
    }
}
END_TEST

// From close to the surface, and from inside with directions of any length, so that t is of any
// size.
START_TEST(hits_at_any_t)
{
    for (int i = 0; i < MANY; i++) {
        Aimed it = any(i % 2 == 0 ? 6 : 1);
        if (i % 2 == 1)
            it.ray.direction *= pow(10, random_number(-2, 2));
        hit_sphere(it.ray, it.sphere);
    }
}
END_TEST

// The distance back to the near place is so short that its digits are lost if roots are subtracted.
START_TEST(hits_from_just_below_the_surface)
{
    for (int i = 0; i < MANY / 8; i++) {
        Aimed it = random_aimed(1);
        it.ray.origin += (it.near + 1e-11) * it.ray.direction;
        hit_sphere(it.ray, it.sphere);
    }
}
END_TEST

static void list_probes(void)
{
    tests_of("to_object_coordinates");
    test(any_ray_in_object_coordinates);
    tests_of("object_quadratic");
    test(coefficients_of_any_ray);
    tests_of("world_quadratic");
    test(coefficients_of_any_ray_and_sphere);
    tests_of("quadratic_roots");
    test(roots_of_any_quadratic);
    tests_of("sphere_roots");
    test(roots_of_any_ray_and_sphere);
    tests_of("hit_sphere");
    test(hits_of_any_ray_and_sphere);
    test(hits_at_any_t);
    test(hits_from_just_below_the_surface);
}

OF_STEM(list_probes)
