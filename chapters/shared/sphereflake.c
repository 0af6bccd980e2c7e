// sphereflake.c - where the spheres of a sphereflake are.
//
// Eric Haines' 'balls' of the Standard Procedural Databases: a sphere carries nine of a third of
// its radius, each of which carries nine, and so on.
#include "chapters/shared/sphereflake.h"

#include <stdio.h>

enum { CHILDREN = 9 };

// v turned by an angle round a unit axis (Rodrigues).
static vec3 turned(vec3 v, vec3 axis, double angle)
{
    return cos(angle) * v + sin(angle) * vec3_cross(axis, v) +
           (1 - cos(angle)) * vec3_dot(axis, v) * axis;
}

// The places of a sphere's children, if its own parent is below it: three sets of three, one above
// the equator, two on it.
static void place_children(vec3 child[CHILDREN])
{
    const double h = sqrt(0.5);
    const vec3 trio[3] = {vec3_of(h, h, 0), vec3_of(h, 0, -h), vec3_of(0, h, -h)};
    for (int set = 0; set < 3; set++)
        for (int i = 0; i < 3; i++) {
            vec3 v = turned(trio[i], vec3_of(h, -h, 0), asin(2 / sqrt(6)));
            child[3 * set + i] = turned(v, vec3_of(0, 0, 1), set * 2 * PI / 3);
        }
}

// v as seen by someone for whom 'above' is up.
static vec3 upright_on(vec3 above, vec3 v)
{
    vec3 axis = vec3_cross(vec3_of(0, 0, 1), above);
    double sine = vec3_length(axis);
    if (sine == 0)
        return above[2] > 0 ? v : turned(v, vec3_of(0, 1, 0), PI);
    return turned(v, axis / sine, atan2(sine, above[2]));
}

void sphereflake_print(int generation, vec3 center, vec3 above, double radius)
{
    if (generation == 0) {
        printf("s %.12g %.12g %.12g %.12g\n", center[0], center[1], center[2], radius);
        return;
    }
    vec3 child[CHILDREN];
    place_children(child);
    for (int i = 0; i < CHILDREN; i++) {
        vec3 direction = upright_on(above, child[i]);
        sphereflake_print(generation - 1, center + 4.0 / 3 * radius * direction, direction,
                          radius / 3);
    }
}
