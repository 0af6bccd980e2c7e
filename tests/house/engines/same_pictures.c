// same_pictures.c - every engine gives chapter 06's picture: of scenes that are made to be
// difficult, on screens of all sizes, and of random scenes.
//
// Usage: same_pictures [SCENES [FIRST]]: SCENES random scenes, from number FIRST on (100, 1), and
// with the first all others. Each is drawn by plain and by every other engine, with several
// threads, and with every instruction set that the engine was compiled for. The last line counts.
#include "tests/house/engines/compare_engines.h"
#include "tests/house/engines/test_scenes.h"

#include <stdlib.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

static const int one[] = {1, 0}, some[] = {1, 3, 0}, all[] = {1, 2, 3, 77, 0};

static void try_made(const Made *made, const int *threads, How how)
{
    Message message;
    Image image;
    if (!image_create(&image, made->size, &message)) {
        against_fail(made->name, message.text);
        return;
    }
    // Of small scenes plain is compared with itself, by several threads.
    const Engine *next = &engines[made->scene.sphere_count > 1000];
    Work right = {&made->scene, made->camera, &image, 1, NULL, NULL};
    engines[0].cast(&right, &message);
    against_all(made->name, next, &right, threads, how);
    image_free(&image);
}

static void try_all_made(void)
{
    static Made made;
    for (int frame = 0; frame < FRAMES; frame++)
        for (int i = 0; made_difficult(&made, i, (Frame)frame); i++)
            try_made(&made, frame == FRAME_USUAL ? some : one, EACH);
    const Resolution sizes[] = {{1, 1},   {1, 97},  {97, 1},  {2, 3},   {17, 16},  {16, 17},
                                {33, 31}, {31, 33}, {64, 48}, {65, 49}, {1, 4096}, {4096, 1}};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        made_sized(&made, sizes[i]);
        try_made(&made, all, EACH);
    }
    // Across the limit beyond which all is left to plain, and where lengths are extreme.
    for (unsigned i = 0; i < 60; i++) {
        made_far(&made, i, pow(10, 10 + i / 6.0), 1);
        try_made(&made, some, IN_TURNS);
    }
    for (unsigned i = 0; i < 60; i++) {
        made_edge(&made, i, pow(10, 6 + i % 6), pow(10, -0.7 * (i / 6)));
        try_made(&made, some, IN_TURNS);
    }
    static const double radii[] = {1e-250, 1e-100, 1e-59, 1e-30, 1e30, 1e50, 1e100, 1e150, 1e290};
    for (unsigned i = 0; i < 4 * sizeof radii / sizeof radii[0]; i++) {
        made_far(&made, i, pow(10, i % 4 * 3), radii[i / 4]);
        try_made(&made, some, IN_TURNS);
    }
    made_many(&made);
    try_made(&made, all, IN_TURNS);
    made_wide(&made);
    try_made(&made, all, IN_TURNS);
    made_hidden(&made);
    try_made(&made, some, EACH);
}

int main(int argc, char **argv)
{
    int random = argc > 1 ? atoi(argv[1]) : 100, first = argc > 2 ? atoi(argv[2]) : 1;
#ifdef __GLIBC__
    mallopt(M_PERTURB, 0xa5); // no engine finds what another has left in memory
#endif
    if (first == 1)
        try_all_made();
    static Made made;
    for (int i = first; i < first + random; i++) {
        made_at_random(&made, (unsigned)i);
        try_made(&made, some, IN_TURNS);
    }
    return against_end("engines");
}
