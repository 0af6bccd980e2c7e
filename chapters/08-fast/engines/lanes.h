// lanes.h - the same loops for several instruction sets, and which of them this processor has.
//
// A file NAME_lanes.c is compiled once for each kind (Makefile), with LANES_KIND set to the name of
// the kind, and its functions get names of their own: LANES(bins) is bins_avx512, bins_avx2 or
// bins_baseline. Its loops are plain C over arrays. The compiler turns 16 steps at a time into the
// vectors of the instruction set: one of 16 floats, two of 8, or four of 4. A lane is one of the
// 16. Of doubles a vector has half as many. '#pragma omp simd' promises the compiler that no step
// needs the result of another one, except for 'reduction(| : any)': all steps combine their results
// with |, in any order.
//
// The functions in these files take only numbers and arrays, never a vec3, because instruction sets
// pass a vec3 in different ways.
#ifndef CHAPTERS_08_FAST_LANES_H
#define CHAPTERS_08_FAST_LANES_H

#include <math.h>
#include <stddef.h>

enum { LANES = 16 };

typedef enum { LANES_BASELINE, LANES_AVX2, LANES_AVX512, LANES_KINDS } LanesKind;

extern const char *const lanes_names[LANES_KINDS];

// The best that this processor, and the system on it, has.
LanesKind lanes_best(void);

// Tests and benchmarks may allow less than the best.
extern LanesKind lanes_at_most;

// Memory for this many bytes, aligned to a line of the cache, where vectors are read fastest; in
// large pages if it is large, because rays read it at random. NULL if there is not enough. Free it
// with free.
void *lanes_memory(size_t size);

// The address of NAME_avx512, NAME_avx2 or NAME_baseline.
#ifdef __x86_64__
#define LANES_BEST(name)                                                                           \
    (lanes_best() == LANES_AVX512 ? &name##_avx512                                                 \
     : lanes_best() == LANES_AVX2 ? &name##_avx2                                                   \
                                  : &name##_baseline)
#else
#define LANES_BEST(name) (&name##_baseline)
#endif

static inline float smaller(float a, float b)
{
    return a < b ? a : b;
}

static inline float larger(float a, float b)
{
    return a > b ? a : b;
}

// A vector of the scene in a lane, by numbers of its own.
typedef struct {
    double x, y, z;
} Vector;

static inline Vector vector_at(const double *numbers)
{
    return (Vector){numbers[0], numbers[1], numbers[2]};
}

static inline double dot(Vector a, Vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline Vector cross(Vector a, Vector b)
{
    return (Vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline Vector plus(Vector a, Vector b)
{
    return (Vector){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline Vector minus(Vector a, Vector b)
{
    return (Vector){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline Vector times(double s, Vector a)
{
    return (Vector){s * a.x, s * a.y, s * a.z};
}

static inline Vector unit(Vector a)
{
    double length = sqrt(dot(a, a));
    return (Vector){a.x / length, a.y / length, a.z / length};
}

#ifndef LANES_KIND
#define LANES_KIND baseline
#endif
#define LANES_PASTE(name, kind) name##_##kind
#define LANES_NAMED(name, kind) LANES_PASTE(name, kind)
#define LANES(name) LANES_NAMED(name, LANES_KIND)

#endif
