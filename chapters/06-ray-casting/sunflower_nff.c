// sunflower_nff.c - writes a beautiful scene: a bowl of spheres, placed like the seeds of a
// sunflower.
//
// Each sphere is turned by the golden angle from the one before, so that no two are in line. They
// grow outward, and their colors go once around the wheel.
#include "common/options.h"
#include "common/vec3.h"

#include <stdio.h>

enum { SEEDS = 420 };

// A color of the wheel, hue from 0 to 1: three cosines a third of a turn apart.
static vec3 wheel(double hue)
{
    vec3 color = vec3_of(0, 0, 0);
    for (int i = 0; i < 3; i++)
        color[i] = 0.55 + 0.42 * cos(2 * PI * (hue - i / 3.0));
    return color;
}

int main(int argc, char **argv)
{
    printed_or_failed(argv[0]);
    if (argc != 1) {
        fprintf(stderr, "Usage: %s\n", argv[0]);
        return 2;
    }
    const double golden_angle = PI * (3 - sqrt(5));
    printf("# %d spheres laid like the seeds of a sunflower.\n"
           "b 0.07 0.08 0.12\nv\nfrom 0 -7.2 6.4\nat 0 0.15 -0.35\nup 0 0 1\nangle 40\nhither 1\n"
           "resolution 640 480\nl -4 -6 9\nl 6 -3 5 0.5 0.5 0.6\n",
           SEEDS);
    for (int i = 0; i < SEEDS; i++) {
        double share = (i + 0.5) / SEEDS;
        double distance = 3 * sqrt(share), angle = i * golden_angle;
        vec3 color = wheel(share + 0.08 * sin(8 * angle));
        printf("f %.4f %.4f %.4f 0.8 0.3 30 0 1\n", color[0], color[1], color[2]);
        printf("s %.9g %.9g %.9g %.9g\n", distance * cos(angle), distance * sin(angle),
               0.13 * distance * distance - 0.6, 0.07 + 0.038 * distance);
    }
    return 0;
}
