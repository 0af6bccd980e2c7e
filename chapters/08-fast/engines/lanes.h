// lanes.h - the same loops for several instruction sets, and which of them this processor has.
//
// A file NAME_lanes.c is compiled once for each kind (Makefile), with LANES_KIND set to the name of
// the kind, and its functions get names of their own: LANES(bins) is bins_avx512, bins_avx2 or
// bins_baseline. Its loops are plain C over arrays. The compiler turns 16 steps at a time into the
// vectors of the instruction set: one of 16 floats, two of 8, or four of 4. A lane is one of the
// 16. Of doubles, which are twice as large, a vector has half as many. '#pragma omp simd' promises
// the compiler that no step needs the result of another one, except for 'reduction(| : any)': all
// steps combine their results with |, in any order.
//
// The functions in these files take only numbers and arrays, never a vec3, because instruction sets
// pass a vec3 in different ways.
#ifndef CHAPTERS_08_FAST_LANES_H
#define CHAPTERS_08_FAST_LANES_H

enum { LANES = 16 };

typedef enum { LANES_BASELINE, LANES_AVX2, LANES_AVX512, LANES_KINDS } LanesKind;

extern const char *const lanes_names[LANES_KINDS];

// The best that this processor, and the system on it, has.
LanesKind lanes_best(void);

// Tests and benchmarks may allow less than the best.
extern LanesKind lanes_at_most;

// A table with one entry for each kind that was compiled.
#ifdef __x86_64__
#define LANES_TABLE(name)                                                                          \
    {                                                                                              \
        &name##_baseline, &name##_avx2, &name##_avx512                                             \
    }
#else
#define LANES_TABLE(name)                                                                          \
    {                                                                                              \
        &name##_baseline, &name##_baseline, &name##_baseline                                       \
    }
#endif

#ifndef LANES_KIND
#define LANES_KIND baseline
#endif
#define LANES_PASTE(name, kind) name##_##kind
#define LANES_NAMED(name, kind) LANES_PASTE(name, kind)
#define LANES(name) LANES_NAMED(name, LANES_KIND)

#endif
