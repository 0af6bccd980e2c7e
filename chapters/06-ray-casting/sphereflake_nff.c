// sphereflake_nff.c - writes the sphereflake of the Standard Procedural Databases as NFF.
//
// The first sphere has radius 1/2. Size factors 2, 3, 4 give 91, 820, 7381 spheres. There is no
// floor; each generation has its own color, so that they can be told apart unshaded.
#include "chapters/shared/sphereflake.h"
#include "common/options.h"

#include <stdio.h>

enum { MOST = 6 };

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
    // Fewer pixels for more spheres: a plain ray caster tries every sphere at every pixel.
    const char *resolution = size <= 3 ? "640 480" : "320 240";
    printf("# The sphereflake of the Standard Procedural Databases, size factor %d, no floor.\n"
           "b 0.078 0.361 0.753\nv\nfrom 2.1 1.3 1.7\nat 0 0 0\nup 0 0 1\nangle 45\n"
           "hither 0.01\nresolution %s\nl 4 3 2\nl 1 -4 4\nl -3 1 5\n",
           size, resolution);
    for (int generation = 0; generation <= size; generation++) {
        printf("f %s 0.5 0.5 3.0827 0 0\n", colors[generation]);
        sphereflake_print(generation, vec3_of(0, 0, 0), vec3_of(0, 0, 1), 0.5);
    }
    return 0;
}
