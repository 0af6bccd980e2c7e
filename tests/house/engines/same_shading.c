// same_shading.c - shadows and mirrors through the hierarchy are chapter 07's, on scenes that are
// awkward, and on random ones.
//
// Usage: same_shading [SCENES [FIRST]]: SCENES random scenes, from number FIRST on (100, 1). Of
// each, the colour that every pixel's ray sees is compared to the last digit; and a picture of few
// samples, with one thread and with three, to the byte. The last line counts.
#include "chapters/08-fast/engines/engine.h"
#include "chapters/08-fast/engines/light_paths.h"
#include "chapters/shared/scene_camera.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/07-shading.h"
#include "tests/house/engines/shading_scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int passed, failed;

static void verdict(const char *name, const char *what, int different, int of)
{
    if (different == 0) {
        passed++;
        return;
    }
    failed++;
    printf("not ok: %s: %s: %d of %d differ\n", name, what, different, of);
}

static int differ(LightPaths *paths, const Ray *rays, int first, int count)
{
    int different = 0;
    paths->paths->count = count;
    for (int i = 0; i < count; i++) {
        set_vector(&paths->paths->origin, i, rays[first + i].origin);
        set_vector(&paths->paths->direction, i, rays[first + i].direction);
    }
    path_colors(paths, false);
    for (int i = 0; i < count; i++) {
        Color all = trace_ray(&lit_scene, rays[first + i], lit_depth);
        Color color = vector_of(paths->colors, i);
        different += memcmp(&all, &color, 3 * sizeof(double)) != 0;
    }
    return different;
}

// By the lanes of each kind, and by the chapters' functions.
static void compare_rays(const char *name, Camera camera)
{
    enum { MOST = 1024 };
    static Ray rays[MOST];
    Resolution screen = lit_scene.view.resolution;
    LightWorld world;
    if (!light_world_build(&world, &lit_scene, 1))
        exit(1);
    lanes_at_most = LANES_AVX512;
    const int count = screen.width * screen.height;
    for (int i = 0; i < count && count <= MOST; i++)
        rays[i] = pixel_ray(camera, screen, (Pixel){i % screen.width, i / screen.width});
    Picture picture = {&lit_scene, world.materials, camera, screen};
    const int best = (int)lanes_best();
    for (int kind = 0; kind <= best + 1; kind++) {
        lanes_at_most = kind > best ? LANES_AVX512 : (LanesKind)kind;
        LightPaths paths;
        if (!light_paths_begin(&paths, &world, lit_depth))
            exit(1);
        paths.picture = picture;
        paths.steps = kind > best ? &steps_by_chapters : steps_for(&picture);
        char what[40];
        snprintf(what, sizeof what, "rays, %s", kind > best ? "chapters" : lanes_names[kind]);
        if (kind <= best)
            verdict(name, "steps in lanes", paths.steps == &steps_by_chapters, 1);
        int different = count > MOST;
        for (int first = 0; first < count; first += PATHS)
            different += differ(&paths, rays, first, count - first < PATHS ? count - first : PATHS);
        verdict(name, what, different, count);
        light_paths_end(&paths);
    }
    light_world_free(&world);
}

static void compare_pictures(const char *name, Camera camera, Style style)
{
    Resolution small = {lit_scene.view.resolution.width / 2, lit_scene.view.resolution.height / 2};
    Message message;
    Image right, image;
    if (!image_create(&right, small, &message) || !image_create(&image, small, &message))
        exit(1);
    render(&lit_scene, camera, style, &right);
    for (const Engine *engine = engines; engine->name != NULL; engine++)
        for (int threads = 1; threads <= 3 && engine->light != NULL; threads += 2) {
            Work work = {&lit_scene, camera, &image, threads, NULL, NULL, false};
            char what[60];
            snprintf(what, sizeof what, "%s, %d threads, bytes", engine->name, threads);
            int different = engine->light(&work, style, &message) ? 0 : 1;
            for (int i = 0; i < 3 * small.width * small.height; i++) {
                different += image.rgb[i] != right.rgb[i];
                image.rgb[i] = (uint8_t)~image.rgb[i];
            }
            verdict(name, what, different, 3 * small.width * small.height);
        }
    image_free(&right);
    image_free(&image);
}

static void try_scene(const char *name, bool pictures)
{
    Camera camera;
    if (scene_camera(&lit_scene.view, lit_scene.view.resolution, &camera) != CAMERA_OK)
        return; // a random view along up
    compare_rays(name, camera);
    if (pictures)
        compare_pictures(name, camera, (Style){.samples = 2, .depth = lit_depth, .gamma = 2.2});
}

int main(int argc, char **argv)
{
    int random = argc > 1 ? atoi(argv[1]) : 100, first = argc > 2 ? atoi(argv[2]) : 1;
    for (size_t i = 0; lit_awkward[i].name != NULL; i++)
        for (int k = 0; k < lit_awkward[i].times; k++) {
            lit_awkward[i].make();
            try_scene(lit_awkward[i].name, k == 0);
        }
    for (int i = first; i < first + random; i++) {
        char name[40];
        snprintf(name, sizeof name, "random scene %d", i);
        lit_at_random((unsigned)i);
        try_scene(name, i % 4 == 0);
    }
    printf("shading engines: %d passed, %d failed\n", passed, failed);
    return failed > 0;
}
