// same_pictures_of_files.c - every engine gives the same picture of a scene in a file.
//
// Usage: same_pictures_of_files WIDTHxHEIGHT MOST-TESTS SCENE.nff...
//
// Against plain, chapter 06's loop, if that takes at most the given number of tests of a ray and a
// sphere (a number like 1e10). Beyond it against bvh, and rows of that, scattered over the picture,
// against chapter 06. The last line counts.
#include "chapters/shared/scene_camera.h"
#include "tests/house/engines/compare_engines.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

enum { ROWS = 24 };
#define ROW_TESTS 5e7 // in all rows of a picture

static const int threads[] = {1, 2, 3, 0};

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
        against_all(name, &engines[1], &right, threads,
                    scene->sphere_count > 200000 ? BEST_SET : IN_TURNS);
    }
    image_free(&image);
}

int main(int argc, char **argv)
{
    Resolution size;
    if (argc < 3 || sscanf(argv[1], "%dx%d", &size.width, &size.height) != 2) {
        fprintf(stderr, "Usage: %s WIDTHxHEIGHT MOST-TESTS SCENE.nff...\n", argv[0]);
        return 2;
    }
    for (int i = 3; i < argc; i++) {
        Scene scene;
        Message message;
        if (scene_load(argv[i], &scene, &message))
            try_scene(argv[i], &scene, size, strtod(argv[2], NULL));
        else
            against_fail(argv[i], message.text);
        scene_free(&scene);
    }
    return against_end("engines, long");
}
