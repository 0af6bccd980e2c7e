// lanes.h - the same loops for several instruction sets, and which of them this processor has.
//
// A file NAME_lanes.c is compiled once for each kind (Makefile), with LANES_KIND set to its name,
// and gives what is in it under a name of its own: LANES(bins) is bins_avx512, bins_avx2 or
// bins_baseline. Its loops are plain C over arrays; the compiler makes of 16 steps at a time what
// the instruction set has: one vector of 16 floats, two of 8, four of 4. A lane is one of the 16.
// '#pragma omp simd' promises the compiler that no step needs what another one finds, but for what
// is in 'reduction(| : any)': to that all add with |, in any order.
//
// Such objects take numbers and arrays only, never a vec3: between instruction sets that is passed
// in different ways.
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
