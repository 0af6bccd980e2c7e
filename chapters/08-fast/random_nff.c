// random_nff.c - writes a scene of random spheres in a cube; their number is an argument.
//
// Centers uniform in [-1, 1]^3, radii uniform from 0.2 to 0.6 times the mean distance between
// neighbours, 2 / cbrt(n), so that a ray passes many and hits one. The spheres are the same every
// time.
#include "common/options.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>

enum { COLORS = 8 };

// SplitMix64 (Steele, Lea and Flood, 2014).
static double uniform(double low, double high)
{
    static uint64_t state = 1;
    uint64_t z = state += 0x9e3779b97f4a7c15;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return low + (high - low) * (double)((z ^ z >> 31) >> 11) * 0x1p-53;
}

int main(int argc, char **argv)
{
    printed_or_failed(argv[0]);
    int count;
    if (argc != 2 || !option_whole(argv[1], 1, INT_MAX, &count)) {
        fprintf(stderr, "Usage: %s NUMBER-OF-SPHERES, a whole number from 1 on\n", argv[0]);
        return 2;
    }
    printf("# %d random spheres.\nb 0.078 0.361 0.753\nv\nfrom 1.5 1.2 3\nat 0 0 0\nup 0 1 0\n"
           "angle 72.734\nhither 0.01\nresolution 1920 1080\nl 4 6 5\n",
           count);
    const double spacing = 2 / cbrt(count);
    for (int i = 0, color = 0; i < count; i++) {
        if (i >= (double)count * color / COLORS) {
            double share = (color++ + 0.5) / COLORS;
            printf("f %.3f %.3f %.3f 0.7 0.3 10 0 1\n", 1 - 0.8 * share, 0.3 + 0.6 * share,
                   0.2 + 0.3 * share);
        }
        double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
        printf("s %.9g %.9g %.9g %.9g\n", x, y, z, spacing * uniform(0.2, 0.6));
    }
    return 0;
}
