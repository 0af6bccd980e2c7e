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

// What must come out: to 1e-9 of the numbers that go in, and of the light for a colour.
double largest(vec3 v); // of its three numbers, without their signs
void expect_normal(Sphere sphere, vec3 point, vec3 normal);
void expect_ray_to_light(vec3 from, Light light, vec3 direction);
void expect_mirrored(vec3 direction, vec3 normal, vec3 mirrored);
void expect_ambient(Color surface, double kd, Color ambient, Color color);
void expect_diffuse(Color surface, double kd, Color light, vec3 normal, vec3 to_light, Color color);
void expect_phong(double ks, double shine, Color light, vec3 normal, vec3 to_light, vec3 to_eye,
                  Color color);
void expect_halfway(double ks, double shine, Color light, vec3 normal, vec3 to_light, vec3 to_eye,
                    Color color);
void expect_clamped(Color color, Color clamped);
void expect_encoded(Color color, double gamma, Color encoded);

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
// More of each, in 07-shading-scale.c: the tests of a function stand together in the list.
void list_more_of_surface_normal(void);
void list_more_of_ray_to_light(void);
void list_more_of_mirror_direction(void);
void list_more_of_ambient_term(void);
void list_more_of_diffuse_term(void);
void list_more_of_phong_term(void);
void list_more_of_halfway_term(void);
void list_more_of_clamp_color(void);
void list_more_of_gamma_encode(void);

#endif
