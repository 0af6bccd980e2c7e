// alone.c - reading a scene and writing its picture, alone: the least that a user waits for.
//
// Usage: alone SCENE.nff FILE.png WIDTH HEIGHT THREADS. Prints microseconds: reading, writing.
// Between them chapter 08 casts the picture, which is not counted.
#include "chapters/08-fast/engines/engine.h"
#include "chapters/08-fast/engines/parallel.h"
#include "chapters/08-fast/engines/system.h"
#include "chapters/shared/scene_camera.h"
#include "common/workers.h"

#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv)
{
    Scene scene;
    Image image;
    Message message = {"Usage: alone SCENE.nff FILE.png WIDTH HEIGHT THREADS"};
    int threads = argc == 6 ? atoi(argv[5]) : 0;
    workers_are(in_parallel, threads);
    double began = clock_seconds();
    bool done = threads > 0 && scene_load(argv[1], &scene, &message);
    double read = clock_seconds() - began;
    if (done) {
        Resolution size = {atoi(argv[3]), atoi(argv[4])};
        Work work = {.scene = &scene, .image = &image, .threads = threads};
        done = scene_camera(&scene.view, size, &work.camera) == CAMERA_OK &&
               image_create(&image, size, &message) && cast_bins(&work, &message);
    }
    began = clock_seconds();
    done = done && image_write_png(&image, argv[2], &message);
    double written = clock_seconds() - began;
    if (!done) {
        fprintf(stderr, "%s\n", message.text);
        return 1;
    }
    printf("%.0f %.0f\n", 1e6 * read, 1e6 * written);
    return 0;
}
