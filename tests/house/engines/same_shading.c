// same_shading.c - shadows and mirrors through the hierarchy are chapter 07's, on scenes that are
// awkward, and on random ones.
//
// Usage: lit [SCENES [FIRST]]: SCENES random scenes, from number FIRST on (100, 1). Of each, what
// every pixel's ray sees is compared to the last digit; and a picture of few samples, with one
// thread and with three, to the byte. The last line counts.
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

static void compare_rays(const char *name, Camera camera)
{
    Resolution screen = lit_scene.view.resolution;
    LightWorld world;
    if (!light_world_build(&world, &lit_scene, 1))
        exit(1);
    lanes_at_most = LANES_AVX512;
    const int count = screen.width * screen.height;
    Ray rays[PATHS];
    Color colors[PATHS];
    for (LanesKind best = lanes_best(), kind = LANES_BASELINE; kind <= best; kind++) {
        lanes_at_most = kind;
        LightPaths paths;
        if (!light_paths_begin(&paths, &world, lit_depth))
            exit(1);
        int different = 0;
        for (int first = 0; first < count; first += PATHS) {
            int some = count - first < PATHS ? count - first : PATHS;
            for (int i = 0; i < some; i++) {
                int pixel = first + i;
                rays[i] =
                    pixel_ray(camera, screen, (Pixel){pixel % screen.width, pixel / screen.width});
            }
            path_colors(&paths, rays, NULL, some, colors);
            for (int i = 0; i < some; i++) {
                Color all = trace_ray(&lit_scene, rays[i], lit_depth);
                different += memcmp(&all, &colors[i], 3 * sizeof(double)) != 0;
            }
        }
        char what[40];
        snprintf(what, sizeof what, "rays, %s", lanes_names[kind]);
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
            Work work = {&lit_scene, camera, &image, threads, NULL, NULL};
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
