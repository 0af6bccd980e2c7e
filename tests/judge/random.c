// random.c - numbers that look random, and that are the same for the same seed.
//
// SplitMix64 (Steele, Lea, Flood, 'Fast Splittable Pseudorandom Number Generators'). Each test
// starts again, whatever ran before it: from 2015, or, if the environment has SEED, from that seed
// and the test's name. Inputs made from a SEED are hidden from the student. Probes are the same in
// every run.
#include "tests/judge/record.h"
#include "tests/judge/test.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static bool seeded, is_hidden; // by the environment; and in this test
static uint64_t seed, state;

void random_take_seed(void)
{
    const char *wanted = getenv("SEED");
    seeded = wanted != NULL;
    if (!seeded)
        return;
    char *end;
    errno = 0;
    long long number = strtoll(wanted, &end, 10);
    if (!isdigit((unsigned char)wanted[0]) || *end != '\0' || errno != 0) {
        fprintf(stderr, "SEED=%s: expected a whole number from 0 to %lld\n", wanted,
                (long long)INT64_MAX);
        exit(2);
    }
    seed = (uint64_t)number;
}

static uint64_t mixed(uint64_t z)
{
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static uint64_t next(void)
{
    return mixed(state += 0x9e3779b97f4a7c15u);
}

void random_begin(const char *test, bool is_probe)
{
    is_hidden = seeded && !is_probe;
    state = is_hidden ? seed : 2015;
    if (!is_hidden && !is_probe)
        return;
    for (; *test != '\0'; test++)
        state = next() ^ (unsigned char)*test;
    state = next();
}

double random_number(double low, double high)
{
    if (is_hidden)
        record_now()->hidden = true;
    return low + (high - low) * (double)(next() >> 11) / 9007199254740992.0;
}

double random_scale(int i, int count)
{
    double jitter = random_number(0, 1);
    if (i == 0 || i == count - 1)
        return i == 0 ? 1e-6 : 1e6;
    return pow(10, -6 + 12 * (i + jitter) / count);
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
        up = -up; // the other handedness
    // One by one: C does not define in which order an initialiser calls them.
    vec3 origin = random_vec3(-5, 5);
    double distance = random_number(0.5, 6), width = random_number(0.5, 4);
    return (Camera){.origin = origin,
                    .right = right,
                    .up = up,
                    .forward = forward,
                    .distance = distance,
                    .width = width,
                    .height = random_number(0.5, 4)};
}

Ray random_ray(double origin, double direction)
{
    vec3 from = random_vec3(-origin, origin);
    return (Ray){from, random_vec3(-direction, direction)};
}

Sphere random_sphere(double center, double low, double high)
{
    vec3 place = random_vec3(-center, center);
    return (Sphere){.center = place, .radius = random_number(low, high)};
}

Resolution random_screen(int low, int below)
{
    int width = (int)random_number(low, below);
    return (Resolution){width, (int)random_number(low, below)};
}

Pixel random_pixel(Resolution screen)
{
    int column = (int)random_number(0, screen.width);
    return (Pixel){column, (int)random_number(0, screen.height)};
}
