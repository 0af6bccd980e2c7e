// laws.h - the laws of exercise 05.
#ifndef TESTS_05_QUADRATIC_LAWS_H
#define TESTS_05_QUADRATIC_LAWS_H

#include "exercises/05-quadratic.h"

#include "tests/judge/law.h"

void law_to_object_coordinates(Ray yours, Ray ray, Sphere sphere);
void law_object_quadratic(Quadratic yours, Ray object_ray, double radius);
void law_world_quadratic(Quadratic yours, Ray ray, Sphere sphere);
void law_quadratic_roots(Roots yours, Quadratic q);
void law_sphere_roots(Roots yours, Ray ray, Sphere sphere);
void law_hit_sphere(double yours, Ray ray, Sphere sphere);

#endif
