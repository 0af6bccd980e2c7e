// random.c - numbers that look random and are the same in every run.
//
// SplitMix64 (Steele, Lea, Flood, 'Fast Splittable Pseudorandom Number Generators'). Each test
// begins with the same seed, whatever ran before it.
#include "tests/judge/test.h"

#include <stdint.h>

static uint64_t state;

void random_begin(void)
{
    state = 2015;
}

double random_number(double low, double high)
{
    uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return low + (high - low) * (double)(z >> 11) / 9007199254740992.0;
}

vec3 random_vec3(double low, double high)
{
    double x = random_number(low, high), y = random_number(low, high);
    return vec3_of(x, y, random_number(low, high));
}

vec3 random_unit(void)
{
    for (;;) {
        vec3 v = random_vec3(-1, 1);
        double length = vec3_length(v);
        if (length > 0.1 && length <= 1)
            return v / length;
    }
}

Camera random_camera(void)
{
    vec3 forward = random_unit();
    vec3 right = vec3_unit(vec3_cross(forward, random_unit()));
    vec3 up = vec3_cross(right, forward);
    if (random_number(0, 1) < 0.5)
        up = -up; // the other hand
    return (Camera){.origin = random_vec3(-5, 5),
                    .right = right,
                    .up = up,
                    .forward = forward,
                    .distance = random_number(0.5, 6),
                    .width = random_number(0.5, 4),
                    .height = random_number(0.5, 4)};
}
