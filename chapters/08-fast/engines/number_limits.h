// number_limits.h - numbers for which only chapter 06's loop is right.
//
// The fast engines decide with margins that cover rounding errors, for a sphere up to EXTREME_RADII
// of its radii away, and for lengths whose fourth powers are in the range of a double. If a scene
// is beyond that, 'plain' casts it, whichever engine was chosen: the picture stays the same.
// Measured (tests/house/engines/same_pictures.c): bins are wrong from 1e14 radii on, object from
// 1e15.5, the others from 1e16.
#ifndef CHAPTERS_08_FAST_ENGINES_NUMBER_LIMITS_H
#define CHAPTERS_08_FAST_ENGINES_NUMBER_LIMITS_H

#include "chapters/08-fast/engines/engine.h"

#include <math.h>

#define EXTREME_RADII 1e12
#define EXTREME_LENGTH 1e60 // and its reciprocal

static inline bool extreme_length(double x)
{
    return !(x >= 1 / EXTREME_LENGTH && x <= EXTREME_LENGTH);
}

static inline bool extreme_place(vec3 place)
{
    return !(fabs(place[0]) <= EXTREME_LENGTH && fabs(place[1]) <= EXTREME_LENGTH &&
             fabs(place[2]) <= EXTREME_LENGTH);
}

// Seen from an eye whose place is not extreme.
static inline bool extreme_sphere(vec3 eye, const Sphere *sphere)
{
    vec3 c = sphere->center - eye;
    double r = EXTREME_RADII * sphere->radius;
    return extreme_place(sphere->center) || extreme_length(sphere->radius) ||
           !(vec3_dot(c, c) <= r * r);
}

bool extreme_camera(Camera camera);

// Whether 'plain' must cast a picture.
bool extreme_scene(const Work *work);

// The same for light: then rays start anywhere, so the largest distance is compared with the radius
// of the smallest sphere.
bool extreme_light(const Work *work);

#endif
