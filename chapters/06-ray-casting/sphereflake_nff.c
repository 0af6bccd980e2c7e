// sphereflake_nff.c - writes the sphereflake of the Standard Procedural Databases as NFF.
//
// Eric Haines' 'balls': a sphere of radius 1/2 that carries nine of a third of its radius, each of
// which carries nine, and so on. Size factors 2, 3, 4 give 91, 820, 7381 spheres. Without
// the floor; each generation has a colour of its own, so that they can be told apart unshaded.
#include "common/options.h"
#include "common/printed.h"
#include "common/vec3.h"

#include <stdio.h>

enum { CHILDREN = 9, MOST = 6 };

// v turned by an angle round a unit axis (Rodrigues).
static vec3 turned(vec3 v, vec3 axis, double angle)
{
    return cos(angle) * v + sin(angle) * vec3_cross(axis, v) +
           (1 - cos(angle)) * vec3_dot(axis, v) * axis;
}

// Where the children of a sphere sit whose own parent is below it: three sets of three, one
// above the equator, two on it.
static void place_children(vec3 child[CHILDREN])
{
    const double h = sqrt(0.5);
    const vec3 trio[3] = {vec3_of(h, h, 0), vec3_of(h, 0, -h), vec3_of(0, h, -h)};
    for (int set = 0; set < 3; set++)
        for (int i = 0; i < 3; i++) {
            vec3 v = turned(trio[i], vec3_of(h, -h, 0), asin(2 / sqrt(6)));
            child[3 * set + i] = turned(v, vec3_of(0, 0, 1), set * 2 * PI / 3);
        }
}

// v as seen by someone for whom 'above' is up.
static vec3 stood_on(vec3 above, vec3 v)
{
    vec3 axis = vec3_cross(vec3_of(0, 0, 1), above);
    double sine = vec3_length(axis);
    if (sine == 0)
        return above[2] > 0 ? v : turned(v, vec3_of(0, 1, 0), PI);
    return turned(v, axis / sine, atan2(sine, above[2]));
}

// The spheres of one generation, in order; those between are only passed through.
static void write_generation(const vec3 child[CHILDREN], int generation, vec3 center, vec3 above,
                             double radius)
{
    if (generation == 0) {
        printf("s %.12g %.12g %.12g %.12g\n", center[0], center[1], center[2], radius);
        return;
    }
    for (int i = 0; i < CHILDREN; i++) {
        vec3 direction = stood_on(above, child[i]);
        write_generation(child, generation - 1, center + 4.0 / 3 * radius * direction, direction,
                         radius / 3);
    }
}

int main(int argc, char **argv)
{
    printed_or_failed(argv[0]);
    static const char *const colors[MOST + 1] = {
        "0.93 0.72 0.35", "0.84 0.38 0.28", "0.62 0.2 0.38", "0.3 0.2 0.5",
        "0.15 0.35 0.6",  "0.2 0.6 0.6",    "0.5 0.8 0.5"};
    int size;
    if (argc != 2 || !option_whole(argv[1], 1, MOST, &size)) {
        fprintf(stderr, "Usage: %s SIZE-FACTOR, from 1 to %d\n", argv[0], MOST);
        return 2;
    }
    vec3 child[CHILDREN];
    place_children(child);
    // Fewer pixels for more spheres: a plain ray caster tries every sphere at every pixel.
    const char *resolution = size <= 3 ? "640 480" : "320 240";
    printf("# The sphereflake of the Standard Procedural Databases, size factor %d, no floor.\n"
           "b 0.078 0.361 0.753\nv\nfrom 2.1 1.3 1.7\nat 0 0 0\nup 0 0 1\nangle 45\n"
           "hither 0.01\nresolution %s\nl 4 3 2\nl 1 -4 4\nl -3 1 5\n",
           size, resolution);
    for (int generation = 0; generation <= size; generation++) {
        printf("f %s 0.5 0.5 3.0827 0 0\n", colors[generation]);
        write_generation(child, generation, vec3_of(0, 0, 0), vec3_of(0, 0, 1), 0.5);
    }
    return 0;
}
