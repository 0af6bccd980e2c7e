// 05-quadratic.h - exercise 05: where a ray meets a sphere.
//
// Slides 'Intersecting a ray and a sphere' and 'Solving quadratic'. Directions have any length
// but 0, so t counts in lengths of the direction. Radii are positive.
// Scale: a world k times as large has t k times as large, and a direction k times as long has t
// 1/k times as large. Tests use worlds from 1e-9 to 1e9 and directions of any length, so no number
// is small in itself.
// Tolerance: 1e-9 of the numbers that go in for a, b, c, and of the larger root for a quadratic;
// for a sphere's roots and hits 1e-6 of the radius along the ray, with the eye at most 1000 radii
// away: the slide's formula is good enough. No test depends on how an exact tangent is rounded.
#ifndef EXERCISES_05_QUADRATIC_H
#define EXERCISES_05_QUADRATIC_H

#include "common/ray.h"
#include "common/sphere.h"

// a t^2 + b t + c = 0
typedef struct {
    double a, b, c;
} Quadratic;

// The real roots, ascending: t[0] <= t[1]. A double root counts as two equal ones.
typedef struct {
    int count; // 0, 1 (only where a = 0) or 2
    double t[2];
} Roots;

// "Assume sphere is centered at origin (replace p with p - c)": the same ray, seen from the
// sphere's centre.
Ray to_object_coordinates(Ray ray, Sphere sphere);

// "Equation to solve?" |p + tv|^2 = r^2 for a ray in object coordinates: its a, b, c as on the
// slide.
Quadratic object_quadratic(Ray object_ray, double radius);

// "What equation would we have to solve if we did this in world coordinates?"
// |(p + tv) - c|^2 = r^2, for a ray and a sphere anywhere.
Quadratic world_quadratic(Ray ray, Sphere sphere);

// The roots of any quadratic. Where a = 0 it is a line with one root, or none where b = 0 too.
Roots quadratic_roots(Quadratic q);

// Both places where the whole line of the ray meets the sphere, behind the origin too; count is
// 0 or 2. Given: it is made of your answers above. Extra, no marks: keep the digits that the
// slide's formula loses for small distant spheres (Haines, Guenther, Akenine-Moeller, 'Precision
// Improvements for Ray/Sphere Intersection', Ray Tracing Gems, chapter 7).
Roots sphere_roots(Ray ray, Sphere sphere);

// The smallest t > 0 at which the ray meets the sphere, or NO_HIT. A tangent ray meets it; from
// inside, it meets the sphere where it leaves.
double hit_sphere(Ray ray, Sphere sphere);

#endif
