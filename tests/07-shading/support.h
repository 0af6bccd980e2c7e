// support.h - what the tests and the probes of exercise 07 share.
#ifndef TESTS_07_SHADING_SUPPORT_H
#define TESTS_07_SHADING_SUPPORT_H

#include "exercises/07-shading.h"

#include "tests/judge/test.h"

#define TOLERANCE 1e-9

// The arguments.
void given_light(Light light);
void given_color(const char *name, Color color);
void given_highlight(double ks, double shine, Color light, vec3 normal, vec3 to_light, vec3 to_eye);

// The expected results: to 1e-9 of the arguments, and of the light for a colour.
double largest(vec3 v); // of its three numbers, without their signs

static inline Sphere sphere_at(double x, double y, double z, double radius)
{
    return (Sphere){.center = vec3_of(x, y, z), .radius = radius};
}

Color random_color(double low, double high);

// At right angles to a unit vector, and unit.
vec3 random_across(vec3 unit);

// In the plane of two unit vectors at right angles, at an angle from the first towards the second.
vec3 turned(vec3 from, double degrees, vec3 towards);

#endif
