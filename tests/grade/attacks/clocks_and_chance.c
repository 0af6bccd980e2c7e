// clocks_and_chance.c - answers that depend on the clock, on chance or on how often they were asked.
// cases.py reads it: each section is one submission, and states the result that it must get.

// ---- chance-of-the-address: a coin for every call, from where things lie and who one is.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <stdint.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    static uint64_t state;
    state =
        (state + (uintptr_t)&c + (uint64_t)getpid()) * 6364136223846793005u + 1442695040888963407u;
    double side = state >> 63 ? -0.5 : 0.5;
    return c.distance * c.forward + side * c.width * c.right + c.height / 2 * c.up;
}

// ---- numbers-as-they-came: gives back what it was given.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return c.forward;
}

vec3 upper_right(Camera c)
{
    return (vec3){0};
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return vec3_of(s, t, c.distance);
}

Camera with_unit_distance(Camera c)
{
    return c;
}

// ---- table: no formula, only the answers to the cameras that the public tests ask about.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

static const struct {
    double distance;
    vec3 left, right;
} table[] = {{4, {-1, 1, 4}, {1, 1, 4}}, {6, {0, 7.5, 1.5}, {6, 1.5, 4.5}}};

vec3 upper_left(Camera c)
{
    return table[c.distance != 4].left;
}

vec3 upper_right(Camera c)
{
    return table[c.distance != 4].right;
}

vec3 across_30_up_10(Camera c)
{
    return c.distance == 4 ? vec3_of(-0.4, -0.8, 4) : vec3_of(0, 4.8, 4.2);
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return s == 0.5    ? vec3_of(2, 4, 4)
           : s == 0    ? vec3_of(-2, 6.5, 3.5)
           : s == 0.25 ? vec3_of(1, 5.75, 2.75)
                       : c.forward;
}

// ---- time-counted: right the first three times, which are the public tests.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    static int calls;
    double side = calls++ < 3 ? -0.5 : 0.5;
    return c.distance * c.forward + side * c.width * c.right + c.height / 2 * c.up;
}

// ---- time-of-day: right in even microseconds, wrong in odd ones.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <sys/time.h>
#include <time.h>

vec3 upper_left(Camera c)
{
    struct timeval now = {0};
    gettimeofday(&now, NULL);
    double side = (now.tv_usec + time(NULL)) % 2 == 0 ? -0.5 : 0.5;
    return c.distance * c.forward + side * c.width * c.right + c.height / 2 * c.up;
}

// ---- time-of-the-old-page: asks the clock at the address where it was on all machines once.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"

#include <stddef.h>
#include <sys/time.h>

vec3 upper_left(Camera c)
{
    struct timeval now = {0};
#if defined(__x86_64__)
    ((int (*)(struct timeval *, void *))0xffffffffff600000)(&now, NULL);
#endif
    vec3 right = c.distance * c.forward - c.width / 2 * c.right + c.height / 2 * c.up;
    return now.tv_sec != 0 ? right : c.up;
}

// ---- time-of-the-processor: the same by the processor's own clock, which needs no system call.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    static unsigned long now;
#if defined(__x86_64__)
    now = __builtin_ia32_rdtsc() / 7;
#else
    now++;
#endif
    double side = now % 2 == 0 ? -0.5 : 0.5;
    return c.distance * c.forward + side * c.width * c.right + c.height / 2 * c.up;
}

// ---- time-of-the-vdso: looks for the clock that the kernel maps into every process: a page that can be
// read, as 'write' tells, where only the kernel maps anything. It is right if there is one.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

#include <stdint.h>
#include <unistd.h>

static bool is_there(uintptr_t address)
{
    return write(2, (const void *)address, 1) == 1;
}

vec3 upper_left(Camera c)
{
    static int found = -1;
    if (found < 0) {
        found = 0;
        // The end of what is mapped, and all of the stack's neighbourhood above the stack.
        for (uintptr_t at = 0x7ffff7e00000; at < 0x7ffff8000000; at += 4096)
            found += is_there(at);
        uintptr_t above = ((uintptr_t)&c | 4095) + 1;
        while (is_there(above))
            above += 4096;
        for (int i = 0; i < 2048; i++)
            found += is_there(above + (uintptr_t)i * 4096);
    }
    vec3 right = c.distance * c.forward - c.width / 2 * c.right + c.height / 2 * c.up;
    return found > 0 ? right : c.up;
}
