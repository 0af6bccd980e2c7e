// support.h - what the tests and the probes of exercise 05 share.
#ifndef TESTS_05_QUADRATIC_SUPPORT_H
#define TESTS_05_QUADRATIC_SUPPORT_H

#include "exercises/05-quadratic.h"

#include "tests/judge/expect_roots.h"
#include "tests/judge/test.h"

#define TOLERANCE 1e-9
#define ROOT_TOLERANCE 1e-6 // of the radius, along the ray

// The arguments, and the expected results. Tolerances are absolute.
void given_quadratic(Quadratic q);
void given_ray_and_sphere(Ray ray, Sphere sphere);
void expect_quadratic(Quadratic yours, double a, double b, double c);
// a, b, c are sums of products of two of the arguments; size is how large the arguments are.
void expect_quadratic_of_size(Quadratic yours, double a, double b, double c, double size);
void expect_no_roots(Roots yours);
void expect_roots_of(Quadratic q, Roots expected, double within);
void expect_meetings(Ray ray, Sphere sphere, Roots expected, double within);
Roots two(double t, double u);

// The deck's section: the circle of radius 1 around the origin, seen from (-4, -1).
Ray ray_of_the_deck(double x, double y);
Sphere unit_sphere(void);
static inline Sphere sphere_at(double x, double y, double z, double radius)
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

Aimed random_aimed(double radii_away);
// Rays from inside a random sphere, with the near hit behind; away from one, with both behind; and
// past one, with neither.
Aimed random_inside(void);
Aimed random_behind(void);
Aimed random_beside(void);
// The same with everything in the world multiplied by one factor, and the direction by another.
Aimed scaled(Aimed aimed, double world, double length);

#endif
