// memory.c - how much memory bins take beyond the scene and the image.
//
// Usage: memory SPHERES THREADS LARGER: as many random spheres as are asked for, as random_nff.c
// writes them but for their radii, which are LARGER times as large, at 1920 x 1080. The peak of
// the whole process (getrusage) is taken before casting and after; it only rises. Rows of the
// picture are chapter 06's. The last line counts.
#include "tests/house/engines/compare_engines.h"
#include "tests/house/engines/test_scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>

#define MOST_BYTES 48 // a sphere

// In bytes; 0 where it cannot be known.
static double peak(void)
{
    struct rusage usage;
    if (getrusage(RUSAGE_SELF, &usage) != 0)
        return 0;
#ifdef __APPLE__
    return (double)usage.ru_maxrss;
#else
    return 1024 * (double)usage.ru_maxrss;
#endif
}

int main(int argc, char **argv)
{
    if (argc != 4)
        return 2;
    Made made;
    Message message;
    Image image;
    const int count = atoi(argv[1]), threads = atoi(argv[2]);
    if (!made_uniform(&made, count, strtod(argv[3], NULL)) ||
        !image_create(&image, made.size, &message)) {
        fprintf(stderr, "no memory for %d spheres\n", count);
        return 1;
    }
    for (int i = 0; i < 3 * image.size.width * image.size.height; i++)
        image.rgb[i] = 0xa5; // memory counts from when it is used
    Work work = {&made.scene, made.camera, &image, threads, NULL, NULL};
    double before = peak();
    if (!engine_named("bins")->cast(&work, &message))
        against_fail(made.name, message.text);
    double more = (peak() - before) / count;
    printf("%s, %d threads: %.1f bytes a sphere\n", made.name, threads, more);
    char why[80];
    snprintf(why, sizeof why, "%.1f bytes a sphere, expected at most %d", more, MOST_BYTES);
    if (before > 0 && more > 0 && more <= MOST_BYTES)
        passed++;
    else
        against_fail(made.name, why);
    against_rows(made.name, &work, 6, 1e9);
    image_free(&image);
    made_uniform_free(&made);
    return against_end("memory");
}
