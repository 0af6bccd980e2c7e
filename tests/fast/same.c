// same.c - every engine gives chapter 06's picture: on scenes that are awkward, and on random ones.
//
// Usage: same [SCENES [FIRST]]: so many random scenes, from number FIRST on (100, 1). Each is drawn
// by plain and by every other engine, with one thread and with three, and with every instruction
// set that the engine was compiled for. The last line counts.
#include "chapters/06-ray-casting/scene_camera.h"
#include "chapters/08-fast/engine.h"
#include "chapters/08-fast/lanes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 400 };

static int passed, failed;
static Sphere spheres[MOST];
static Surface surfaces[MOST];
static Scene scene = {.spheres = spheres, .surfaces = surfaces};

// ---- scenes -----------------------------------------------------------------------------------

static unsigned long long state;

static double uniform(double low, double high)
{
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return low + (high - low) * (double)(state >> 11) * 0x1p-53;
}

// Every sphere has a colour of its own, so that one taken for another shows.
static void add(double x, double y, double z, double radius)
{
    int i = scene.sphere_count;
    if (i == MOST)
        return;
    surfaces[i].color = vec3_of((i % 7 + 1) / 7.0, (i / 7 % 7 + 1) / 7.0, (i / 49 % 9 + 1) / 9.0);
    spheres[i] = (Sphere){vec3_of(x, y, z), radius, i};
    scene.sphere_count = scene.surface_count = i + 1;
}

static void look_from(vec3 from, vec3 at, double angle, int width, int height)
{
    scene.sphere_count = scene.surface_count = 0;
    scene.view = (Viewpoint){from, at, vec3_of(0.1, 1, 0.2), angle, {width, height}};
}

static const vec3 front = {0, 0, 5}, middle = {0, 0, 0};

static void nothing(void)
{
    look_from(front, middle, 60, 40, 30);
}
static void one_pixel(void)
{
    look_from(front, middle, 60, 1, 1);
    add(0, 0, 0, 1);
}
static void around_the_eye(void)
{
    look_from(front, middle, 60, 40, 30);
    add(0, 0, 5, 1);
    add(0, 0, 0, 1);
    add(0, 0, 5, 30);
}
static void touching_the_eye(void)
{
    look_from(front, middle, 90, 40, 30);
    add(0, 0, 4, 1);
    add(1, 0, 5, 1);
    add(0, -2, 5, 2);
    add(0, 0, 6, 1);
    add(0, 0, 0, 1);
}
static void beside_and_behind(void)
{
    look_from(front, middle, 120, 40, 30);
    add(3, 0, 5, 2.5);
    add(-3, 0, 5.5, 2.9);
    add(0, 0, 9, 3.9);
    add(0, 4, 4, 3);
}
static void coincident(void)
{
    look_from(front, middle, 60, 40, 30);
    for (int i = 0; i < 8; i++)
        add(0, 0, 0, 1);
    for (int i = 0; i < 8; i++)
        add(1, 1, 0, 0.5 + 1e-9 * i);
    for (int i = 0; i < 8; i++)
        add(-1, -1, 1e-12 * i, 0.5);
}
static void tangent(void)
{
    // Seen along an axis the outlines of these run through pixel centres.
    look_from(vec3_of(0, 0, 8), middle, 90, 32, 32);
    scene.view.up = vec3_of(0, 1, 0);
    for (int i = 0; i < 16; i++)
        add((i + 0.5) / 2, 0, 0, 0.25);
    add(-2, -2, 0, 2);
    add(-2, 2, 1, 1);
}
static void tiny_and_huge(void)
{
    look_from(front, middle, 60, 40, 30);
    add(0, 0, -1e6, 9e5);
    add(0, -1e9, 0, 1e9 - 2);
    for (int i = 0; i < 50; i++)
        add(uniform(-2, 2), uniform(-2, 2), uniform(-2, 2), 1e-4 * i);
    add(0, 0, 4.999, 1e-6);
    add(0, 0, -1e12, 1e10);
}
static void of_another_size(void)
{
    look_from(vec3_of(0, 0, 5e-6), middle, 60, 40, 30);
    for (int i = 0; i < 50; i++)
        add(uniform(-2e-6, 2e-6), uniform(-2e-6, 2e-6), uniform(-2e-6, 2e-6), 3e-7);
}
static void far_from_the_origin(void)
{
    vec3 there = vec3_of(1e7, -3e7, 2e7);
    look_from(there + front, there, 60, 40, 30);
    for (int i = 0; i < 50; i++)
        add(there[0] + uniform(-2, 2), there[1] + uniform(-2, 2), there[2] + uniform(-2, 2), 0.4);
}
static void in_one_another(void)
{
    look_from(front, middle, 60, 61, 47);
    for (int i = 0; i < 40; i++)
        add(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), 1);
}

static const struct {
    const char *name;
    void (*make)(void);
} awkward[] = {{"nothing", nothing},
               {"one pixel", one_pixel},
               {"around the eye", around_the_eye},
               {"touching the eye", touching_the_eye},
               {"beside and behind the eye", beside_and_behind},
               {"coincident", coincident},
               {"tangent", tangent},
               {"tiny and huge", tiny_and_huge},
               {"of another size", of_another_size},
               {"far from the origin", far_from_the_origin},
               {"in one another", in_one_another}};

static void at_random(unsigned number)
{
    state = number * 7919ULL + 1;
    for (int i = 0; i < 8; i++)
        uniform(0, 1);
    vec3 from = vec3_of(uniform(-3, 3), uniform(-3, 3), uniform(-3, 3));
    vec3 at = vec3_of(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    look_from(from, at, uniform(5, 150), (int)uniform(1, 90), (int)uniform(1, 70));
    int count = (int)pow(MOST, uniform(0, 1));
    double size = pow(10, uniform(-2, 0));
    for (int i = 0; i < count; i++)
        add(uniform(-2, 2), uniform(-2, 2), uniform(-2, 2), size * uniform(0.1, 1));
}

// ---- pictures ---------------------------------------------------------------------------------

static void fail(const char *name, const Engine *engine, int threads, const char *why)
{
    failed++;
    printf("not ok: %s, %s for %s, %d threads: %s\n", name, engine->name, lanes_names[lanes_best()],
           threads, why);
}

static void compare(const char *name, const Engine *engine, const Work *plain, int threads)
{
    Message message;
    Image image;
    Work work = *plain;
    work.image = &image;
    work.threads = threads;
    if (!image_create(&image, plain->image->size, &message) || !engine->cast(&work, &message)) {
        fail(name, engine, threads, message.text);
        return;
    }
    int width = image.size.width, different = 0, first = -1;
    for (int i = 0; i < width * image.size.height; i++)
        if (memcmp(image.rgb + 3 * i, plain->image->rgb + 3 * i, 3) != 0 && different++ == 0)
            first = i;
    if (different == 0) {
        passed++;
    } else {
        char why[120];
        snprintf(why, sizeof why, "%d of %d pixels differ, first (%d, %d)", different,
                 width * image.size.height, first % width, first / width);
        fail(name, engine, threads, why);
    }
    image_free(&image);
}

// Engines that are not compiled for several instruction sets are tried once.
static int least(const Engine *engine)
{
    static const char *const with_lanes[] = {"packet", "tiles", "bins"};
    for (size_t i = 0; i < sizeof with_lanes / sizeof with_lanes[0]; i++)
        if (strcmp(engine->name, with_lanes[i]) == 0)
            return LANES_BASELINE;
    lanes_at_most = LANES_AVX512;
    return (int)lanes_best();
}

static void try_scene(const char *name)
{
    Message message;
    Image image;
    Camera camera;
    if (scene_camera(&scene.view, scene.view.resolution, &camera) != CAMERA_OK ||
        !image_create(&image, scene.view.resolution, &message))
        return; // a random view along up
    Work work = {&scene, camera, &image, 1};
    engines[0].cast(&work, &message);
    for (const Engine *engine = engines; engine->name != NULL; engine++)
        for (int threads = engine == engines ? 3 : 1; threads <= 3; threads += 2)
            for (int kind = least(engine); kind < LANES_KINDS; kind++) {
                lanes_at_most = (LanesKind)kind;
                if (lanes_best() == lanes_at_most)
                    compare(name, engine, &work, threads);
            }
    lanes_at_most = LANES_AVX512;
    image_free(&image);
}

int main(int argc, char **argv)
{
    int random = argc > 1 ? atoi(argv[1]) : 100, first = argc > 2 ? atoi(argv[2]) : 1;
    for (size_t i = 0; i < sizeof awkward / sizeof awkward[0]; i++) {
        awkward[i].make();
        try_scene(awkward[i].name);
    }
    for (int i = first; i < first + random; i++) {
        char name[40];
        snprintf(name, sizeof name, "random scene %d", i);
        at_random((unsigned)i);
        try_scene(name);
    }
    printf("engines: %d passed, %d failed\n", passed, failed);
    return failed > 0;
}
