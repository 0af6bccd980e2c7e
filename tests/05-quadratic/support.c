// support.c - rays and spheres whose hits are known, and how the tests of exercise 05 describe
// them.
#include "tests/05-quadratic/support.h"

// ---- descriptions ------------------------------------------------------------------------------

void given_quadratic(Quadratic q)
{
    given("a, b, c", "%s, %s, %s", number_text_to(q.a, 12).s, number_text_to(q.b, 12).s,
          number_text_to(q.c, 12).s);
}

void given_ray_and_sphere(Ray ray, Sphere sphere)
{
    given_ray(ray);
    given_sphere(sphere);
}

void expect_quadratic(Quadratic yours, double a, double b, double c)
{
    expect_quadratic_of_size(yours, a, b, c, 1);
}

void expect_quadratic_of_size(Quadratic yours, double a, double b, double c, double size)
{
    given("in order", "a, b, c");
    expect_vec3(vec3_of(yours.a, yours.b, yours.c), vec3_of(a, b, c), TOLERANCE * size * size);
}

void expect_no_roots(Roots yours)
{
    expect_roots(yours, (Roots){0}, 0);
}

void expect_roots_of(Quadratic q, Roots expected, double within)
{
    given_quadratic(q);
    expect_roots(quadratic_roots(q), expected, within);
}

void expect_meetings(Ray ray, Sphere sphere, Roots expected, double within)
{
    given_ray_and_sphere(ray, sphere);
    expect_roots(sphere_roots(ray, sphere), expected, within);
}

Roots two(double t, double u)
{
    return (Roots){2, {t, u}};
}

// ---- rays and spheres --------------------------------------------------------------------------

// The deck's section: the circle of radius 1 around the origin, seen from (-4, -1).
Ray ray_of_the_deck(double x, double y)
{
    return (Ray){vec3_of(-4, -1, 0), vec3_of(x, y, 0)};
}

Sphere unit_sphere(void)
{
    return (Sphere){.center = vec3_of(0, 0, 0), .radius = 1};
}

Aimed random_aimed(double radii_away)
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

Aimed random_inside(void)
{
    for (;;) {
        Aimed aimed = random_aimed(-random_number(0.05, 1.9));
        double to_exit = aimed.far * vec3_length(aimed.ray.direction) / aimed.sphere.radius;
        if (to_exit > 0.05)
            return aimed;
    }
}

Aimed random_behind(void)
{
    return random_aimed(-random_number(2.1, 100));
}

// From a point beside the sphere, where the ray is at right angles to its radius.
Aimed random_beside(void)
{
    Aimed aimed = {.sphere = random_sphere(5, 0.1, 3), .near = NO_HIT, .far = NO_HIT};
    vec3 direction = random_unit(), aside = vec3_unit(vec3_cross(direction, random_unit()));
    double r = aimed.sphere.radius, away = random_number(-100, 100) * r;
    vec3 passed = aimed.sphere.center + random_number(1.05, 3) * r * aside;
    aimed.ray = (Ray){passed - away * direction, random_number(0.1, 10) * direction};
    return aimed;
}

Aimed scaled(Aimed aimed, double world, double length)
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
