// exit-raw: the system call exit_group itself, past every library that could be listening.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: by itself | was killed | no answer
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
#if defined(__x86_64__)
    __asm__ volatile("syscall" : : "a"(231L), "D"(0L) : "rcx", "r11", "memory");
#elif defined(__aarch64__)
    __asm__ volatile("mov x8, #94\n mov x0, #0\n svc #0" : : : "x0", "x8", "memory");
#endif
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
