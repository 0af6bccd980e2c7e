// 05-quadratic.h - exercise 05: where a ray meets a sphere.
//
// Slides 'Intersecting a ray and a sphere' and 'Solving quadratic'. Directions have any length
// except 0, so t counts lengths of the direction. Radii are positive.
// Scale: if the world is k times as large, t is k times as large. If the direction is k times as
// long, t is 1/k times as large. Tests use worlds from 1e-9 to 1e9 and directions of any length, so
// do not compare with a fixed small number.
// Tolerance: 1e-9. For a, b, c it is relative to the numbers that go in. For the roots of a
// quadratic, to the larger root. For roots and hits of a sphere: 1e-6 radii along the ray, if the
// eye is at most 1000 radii away: the slide's formula is good enough. No test depends on the
// rounding of an exact tangent.
#ifndef EXERCISES_05_QUADRATIC_H
#define EXERCISES_05_QUADRATIC_H

#include "common/ray.h"
#include "common/sphere.h"

// a t^2 + b t + c = 0
typedef struct {
    double a, b, c;
} Quadratic;

// The real roots in ascending order: t[0] <= t[1]. A double root counts as two equal roots.
typedef struct {
    int count; // 0, 1 (only if a = 0) or 2
    double t[2];
} Roots;

// "Assume sphere is centered at origin (replace p with p - c)": returns the same ray, seen from the
// center of the sphere.
Ray to_object_coordinates(Ray ray, Sphere sphere);

// "Equation to solve?" It is |p + tv|^2 = r^2 for a ray in object coordinates. Returns its a, b, c
// as on the slide.
Quadratic object_quadratic(Ray object_ray, double radius);

// "What equation would we have to solve if we did this in world coordinates?"
// It is |(p + tv) - c|^2 = r^2, for a ray and a sphere anywhere. Returns its a, b, c.
Quadratic world_quadratic(Ray ray, Sphere sphere);

// Returns the roots of any quadratic. If a = 0 it is a line: it has one root, or none if b is also
// 0.
Roots quadratic_roots(Quadratic q);

// Returns both points where the whole line of the ray meets the sphere, also those behind the
// origin; count is 0 or 2. This function is given: it calls your answers above. Extra, no marks:
// keep the digits that the slide's formula loses for small distant spheres (Haines, Guenther,
// Akenine-Moeller, 'Precision Improvements for Ray/Sphere Intersection', Ray Tracing Gems, chapter
// 7).
Roots sphere_roots(Ray ray, Sphere sphere);

// Returns the smallest t > 0 at which the ray meets the sphere, or NO_HIT. A tangent ray meets the
// sphere. A ray that starts inside meets it where it leaves.
double hit_sphere(Ray ray, Sphere sphere);

#endif
