// 07-shading.h - what the tests of exercise 07 share.
#ifndef TESTS_07_SHADING_H
#define TESTS_07_SHADING_H

#include "exercises/07-shading.h"

#include "tests/judge/test.h"

#define TOLERANCE 1e-9

// What goes in.
void given_light(Light light);
void given_color(const char *name, Color color);
void given_highlight(double ks, double shine, Color light, vec3 normal, vec3 to_light, vec3 to_eye);

Sphere sphere_at(double x, double y, double z, double radius);
Color random_color(double low, double high);

// At right angles to a unit vector, and unit.
vec3 random_across(vec3 unit);

// In the plane of two unit vectors at right angles, so far from the first towards the second.
vec3 turned(vec3 from, double degrees, vec3 towards);

// The tests, a file each.
void list_tests_of_vectors(void);
void list_tests_of_terms(void);
void list_tests_of_phong(void);
void list_tests_of_halfway(void);
void list_tests_of_colors(void);

#endif
