// finale_nff.c - writes the scene of the last picture: a sphereflake of mirrors among marbles.
//
// All is spheres. The floor is one so large that it looks flat, and the sky is the inside of
// another, so that the mirrors have something to show.
#include "chapters/shared/sphereflake.h"
#include "common/options.h"

#include <stdio.h>

enum { GENERATIONS = 3, MARBLES = 1800 };

static const double floor_height = -0.5, floor_radius = 1000;

static void print_fill(vec3 color, double diffuse, double specular, double shine)
{
    printf("f %.3f %.3f %.3f %g %g %g 0 1\n", color[0], color[1], color[2], diffuse, specular,
           shine);
}

// A color of the wheel, hue from 0 to 1: three cosines a third of a turn apart.
static vec3 wheel(double hue)
{
    vec3 color = vec3_of(0, 0, 0);
    for (int i = 0; i < 3; i++)
        color[i] = 0.52 + 0.42 * cos(2 * PI * (hue - i / 3.0));
    return color;
}

static void print_sphere(vec3 center, double radius)
{
    printf("s %.9g %.9g %.9g %.9g\n", center[0], center[1], center[2], radius);
}

// Laid like the seeds of a sunflower: each turned by the golden angle from the one before.
static void print_marbles(void)
{
    const double golden_angle = PI * (3 - sqrt(5));
    for (int i = 0; i < MARBLES; i++) {
        double distance = 0.22 * sqrt(i + 0.5), angle = i * golden_angle;
        double radius = 0.05 + 0.0125 * distance;
        if (distance < 1.1)
            continue;
        vec3 color = wheel(-0.06 + 0.8 * i / MARBLES);
        print_fill(color, 0.75, 0.2, 60);
        double bottom = floor_height - distance * distance / (2 * floor_radius);
        print_sphere(vec3_of(distance * cos(angle), distance * sin(angle), bottom + radius),
                     radius);
    }
}

int main(int argc, char **argv)
{
    printed_or_failed(argv[0]);
    if (argc != 1) {
        fprintf(stderr, "Usage: %s\n", argv[0]);
        return 2;
    }
    printf("# The last picture: a sphereflake of mirrors among marbles.\n"
           "b 0 0 0\nv\nfrom 3.95 2.8 1.62\nat 0 0 0.1\nup 0 0 1\nangle 34\nhither 0.01\n"
           "resolution 1280 720\n"
           "l -34.7 -44.5 3 1 0.6 0.3\nl 2.5 7.5 7 1 0.98 0.92\nl 6 -5 2 0.2 0.3 0.5\n");
    print_fill(vec3_of(0.15, 0.19, 0.36), 0.9, 0, 1);
    print_sphere(vec3_of(0, 0, 0), 60);
    print_fill(vec3_of(0.16, 0.17, 0.22), 0.7, 0.4, 200);
    print_sphere(vec3_of(0, 0, floor_height - floor_radius), floor_radius);
    const struct {
        vec3 color;
        double diffuse, specular, shine;
    } of_generation[GENERATIONS + 1] = {
        {vec3_of(0.9, 0.92, 1), 0.1, 0.85, 200},
        {vec3_of(1, 0.72, 0.26), 0.75, 0.35, 60},
        {vec3_of(0.9, 0.15, 0.12), 0.75, 0.25, 50},
        {vec3_of(0.15, 0.75, 0.75), 0.8, 0.2, 40},
    };
    for (int i = 0; i <= GENERATIONS; i++) {
        print_fill(of_generation[i].color, of_generation[i].diffuse, of_generation[i].specular,
                   of_generation[i].shine);
        sphereflake_print(i, vec3_of(0, 0, 0), vec3_of(0, 0, 1), 0.5);
    }
    print_marbles();
    return 0;
}
