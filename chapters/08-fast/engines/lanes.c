// lanes.c - which instruction sets this processor has.
#include "chapters/08-fast/engines/lanes.h"

const char *const lanes_names[LANES_KINDS] = {"baseline", "avx2", "avx512"};

LanesKind lanes_at_most = LANES_AVX512;

// Asks for exactly the instruction sets that the Makefile compiles for. The compiler's library also
// asks whether the system saves the wide registers.
static LanesKind lanes_of_processor(void)
{
#ifdef __x86_64__
    __builtin_cpu_init();
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma"))
        return LANES_BASELINE;
    if (!__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512vl") ||
        !__builtin_cpu_supports("avx512bw") || !__builtin_cpu_supports("avx512dq"))
        return LANES_AVX2;
    return LANES_AVX512;
#else
    return LANES_BASELINE;
#endif
}

LanesKind lanes_best(void)
{
    LanesKind kind = lanes_of_processor();
    return kind < lanes_at_most ? kind : lanes_at_most;
}
