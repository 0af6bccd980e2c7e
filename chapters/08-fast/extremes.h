// extremes.h - numbers that only chapter 06's loop is right about.
//
// The quick engines decide with margins that cover what is rounded off, for a sphere that is up to
// EXTREME_RADII of its radii away, and for lengths whose squares of squares a double holds. A scene
// that goes beyond is cast by 'plain', whichever engine was asked for: the picture stays the same.
// Tried (tests/house/engines/same.c): bins err from 1e14 radii on, object from 1e15.5, the others
// from 1e16.
#ifndef CHAPTERS_08_FAST_EXTREMES_H
#define CHAPTERS_08_FAST_EXTREMES_H

#include "chapters/08-fast/engine.h"

#include <math.h>

#define EXTREME_RADII 1e12
#define EXTREME_LENGTH 1e60 // and 1 over it

static inline bool extreme_length(double x)
{
    return !(x >= 1 / EXTREME_LENGTH && x <= EXTREME_LENGTH);
}

static inline bool extreme_place(vec3 place)
{
    return !(fabs(place[0]) <= EXTREME_LENGTH && fabs(place[1]) <= EXTREME_LENGTH &&
             fabs(place[2]) <= EXTREME_LENGTH);
}

// As seen from an eye whose place is not extreme.
static inline bool extreme_sphere(vec3 eye, const Sphere *sphere)
{
    vec3 c = sphere->center - eye;
    double r = EXTREME_RADII * sphere->radius;
    return extreme_place(sphere->center) || extreme_length(sphere->radius) ||
           !(vec3_dot(c, c) <= r * r);
}

bool extreme_camera(Camera camera);

// Whether a picture has to be cast by 'plain'.
bool extreme_scene(const Work *work);

// The same for light: rays start anywhere then, so the largest distance counts, in radii of the
// smallest sphere.
bool extreme_light(const Work *work);

#endif
