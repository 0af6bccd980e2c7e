// vec3.h - the vector algebra of every chapter.
//
// A vec3 is a point, a vector or a color of three doubles. The compiler adds, subtracts and
// scales it, so the slide's expression is the code:  d * f - w / 2 * r + h / 2 * u
// Products have names (vec3_dot, vec3_cross); components are v[0], v[1], v[2], not v.x.
#ifndef COMMON_VEC3_H
#define COMMON_VEC3_H

#include <math.h>
#include <stdbool.h>

#define PI 3.14159265358979323846 // C11 has no M_PI

// Traps:
// - a fourth double fills the 32 bytes, and is not part of the vector: never compare, hash or
//   print it;
// - v * w is the product component by component (good for colors); for v . w write vec3_dot;
// - v + 1 compiles, and adds 1 to every component; it is hardly ever what you mean;
// - v[0] has no address: write  v[0] = x,  never  &v[0].
// Aligned to 16, as malloc is, so that arrays from malloc hold it.
typedef double vec3 __attribute__((vector_size(32), aligned(16)));

static inline vec3 vec3_of(double x, double y, double z)
{
    return (vec3){x, y, z, 0};
}

static inline double vec3_dot(vec3 v, vec3 w)
{
    return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
}

// At right angles to both; x cross y is z. Its length is |v| |w| sin(angle between).
static inline vec3 vec3_cross(vec3 v, vec3 w)
{
    return vec3_of(v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]);
}

// Right for lengths from 1e-150 to 1e150; beyond, squares leave the range of a double.
static inline double vec3_length(vec3 v)
{
    return sqrt(vec3_dot(v, v));
}

// The same direction with length 1. The zero vector has none: its answer is not a number.
static inline vec3 vec3_unit(vec3 v)
{
    return v / vec3_length(v);
}

static inline bool vec3_is_finite(vec3 v)
{
    return isfinite(v[0]) && isfinite(v[1]) && isfinite(v[2]);
}

#endif
