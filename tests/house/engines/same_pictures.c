// same_pictures.c - every engine gives chapter 06's picture, and bins take little memory for it.
//
//   same_pictures [SCENES [FIRST]]
//
// SCENES random scenes, from number FIRST on (100, 1), and with the first all scenes that are made
// to be difficult, on screens of all sizes. Each is drawn by plain and by every other engine, with
// several threads, and with every instruction set that the engine was compiled for.
//
//   same_pictures WIDTHxHEIGHT MOST-TESTS SCENE.nff...
//
// Against plain, chapter 06's loop, if that takes at most the given number of tests of a ray and a
// sphere (a number like 1e10). Beyond it against bvh, and rows of that, scattered over the picture,
// against chapter 06.
//
//   same_pictures --memory SPHERES
//
// As many random spheres as random_nff.c writes them, at 1920 x 1080. The peak of the whole process
// (getrusage) is taken before casting and after; it only rises. Rows of the picture are chapter
// 06's. The last line counts.
#include "chapters/shared/scene_camera.h"
#include "tests/house/engines/compare_engines.h"
#include "tests/house/engines/test_scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

enum { ROWS = 24 };
#define ROW_TESTS 5e7 // in all rows of a picture
#define MOST_BYTES 48 // a sphere

static const int one[] = {1, 0}, some[] = {1, 3, 0}, more[] = {1, 2, 3, 0},
                 all[] = {1, 2, 3, 77, 0};

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

static void try_random(int count, int first)
{
#ifdef __GLIBC__
    mallopt(M_PERTURB, 0xa5); // no engine finds what another has left in memory
#endif
    if (first == 1)
        try_all_made();
    static Made made;
    for (int i = first; i < first + count; i++) {
        made_at_random(&made, (unsigned)i);
        try_made(&made, some, IN_TURNS);
    }
}

// ---- files -----------------------------------------------------------------------------------

static void try_scene(const char *name, const Scene *scene, Resolution size, double most)
{
    Message message;
    Image image;
    Camera camera;
    if (scene_camera(&scene->view, size, &camera) != CAMERA_OK ||
        !image_create(&image, size, &message)) {
        against_fail(name, "no camera, or no image");
        return;
    }
    Work right = {scene, camera, &image, (int)sysconf(_SC_NPROCESSORS_ONLN), NULL, NULL};
    bool few = (double)size.width * size.height * scene->sphere_count <= most;
    const Engine *engine = few ? &engines[0] : engine_named("bvh");
    if (!engine->cast(&right, &message)) {
        against_fail(name, message.text);
    } else {
        against_rows(name, &right, ROWS, ROW_TESTS);
        // Hierarchies of many spheres take long to build.
        against_all(name, &engines[1], &right, more,
                    scene->sphere_count > 200000 ? BEST_SET : IN_TURNS);
    }
    image_free(&image);
}

static void try_file(const char *path, Resolution size, double most)
{
    Scene scene;
    Message message;
    if (scene_load(path, &scene, &message))
        try_scene(path, &scene, size, most);
    else
        against_fail(path, message.text);
    scene_free(&scene);
}

// ---- memory ----------------------------------------------------------------------------------

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

static void try_memory(int count)
{
    enum { THREADS = 2 };
    Made made;
    Message message;
    Image image;
    if (!made_uniform(&made, count) || !image_create(&image, made.size, &message)) {
        against_fail("memory", "not enough to try");
        return;
    }
    for (int i = 0; i < 3 * image.size.width * image.size.height; i++)
        image.rgb[i] = 0xa5; // memory counts from when it is used
    Work work = {&made.scene, made.camera, &image, THREADS, NULL, NULL};
    double before = peak();
    if (!engine_named("bins")->cast(&work, &message))
        against_fail(made.name, message.text);
    double more_now = (peak() - before) / count;
    char why[80];
    snprintf(why, sizeof why, "%.1f bytes a sphere, expected at most %d", more_now, MOST_BYTES);
    if (before > 0 && more_now > 0 && more_now <= MOST_BYTES)
        passed++;
    else
        against_fail(made.name, why);
    against_rows(made.name, &work, 6, 1e9);
    image_free(&image);
    made_uniform_free(&made);
}

int main(int argc, char **argv)
{
    Resolution size;
    if (argc == 3 && strcmp(argv[1], "--memory") == 0)
        try_memory(atoi(argv[2]));
    else if (argc > 2 && sscanf(argv[1], "%dx%d", &size.width, &size.height) == 2)
        for (int i = 3; i < argc; i++)
            try_file(argv[i], size, strtod(argv[2], NULL));
    else
        try_random(argc > 1 ? atoi(argv[1]) : 100, argc > 2 ? atoi(argv[2]) : 1);
    return against_end("engines");
}
