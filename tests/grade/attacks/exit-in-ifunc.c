// exit-in-ifunc: a resolver runs while the program is still being linked into memory.
// stem: 01-corners
// expect: crashed
// earns: nothing
#include "exercises/01-corners.h"

static vec3 wrong(Camera c)
{
    return c.up;
}

static void *resolve(void)
{
#if defined(__x86_64__)
    __asm__ volatile("syscall" : : "a"(231L), "D"(0L) : "rcx", "r11", "memory");
#elif defined(__aarch64__)
    __asm__ volatile("mov x8, #94\n mov x0, #0\n svc #0" : : : "x0", "x8", "memory");
#endif
    return (void *)wrong;
}

static vec3 helper(Camera c) __attribute__((ifunc("resolve")));

vec3 upper_left(Camera c)
{
    return helper(c);
}
