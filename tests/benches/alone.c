// alone.c - reads a scene and writes its picture: what programs take besides casting.
//
// Usage: alone SCENE.nff FILE.png WIDTH HEIGHT THREADS. Between the two it casts the picture. It
// says how many seconds that takes, as a double for turns.c, which does not count them.
#include "chapters/08-fast/engines/engine.h"
#include "chapters/08-fast/engines/parallel.h"
#include "chapters/shared/scene_camera.h"
#include "common/clock.h"
#include "common/workers.h"
#include "tests/benches/turns.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

int main(int argc, char **argv)
{
    if (argc != 6) {
        fprintf(stderr, "Usage: alone SCENE.nff FILE.png WIDTH HEIGHT THREADS\n");
        return 2;
    }
    Scene scene;
    Image image;
    Message message = {"no camera"};
    Resolution size = {atoi(argv[3]), atoi(argv[4])};
    Work work = {.scene = &scene, .image = &image, .threads = atoi(argv[5])};
    workers_are(in_parallel, one_at_a_time, work.threads);
    bool done = scene_load(argv[1], &scene, &message) &&
                scene_camera(&scene.view, size, &work.camera) == CAMERA_OK &&
                image_create(&image, size, &message);
    double began = clock_seconds();
    done = done && cast_bins(&work, &message);
    double seconds = clock_seconds() - began;
    done = done && image_write_png(&image, argv[2], &message);
    if (!done || write(NOT_COUNTED, &seconds, sizeof seconds) != sizeof seconds) {
        fprintf(stderr, "alone: %s\n", done ? "nobody wants to know the seconds" : message.text);
        return 1;
    }
    image_free(&image);
    scene_free(&scene);
    return 0;
}
