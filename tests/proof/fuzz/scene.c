// scene.c - a libFuzzer target: any bytes are a scene, or are refused with a message.
//
//   clang -std=c11 -D_DEFAULT_SOURCE -Wno-psabi -I. -g -O1 -fno-sanitize-recover=all
//         -fsanitize=fuzzer,address,undefined tests/proof/fuzz/scene.c
//         common/scene.c common/nff_*.c common/text.c common/answers.c -lm -o fuzz-scene
//   ./fuzz-scene -dict=tests/proof/fuzz/nff.dict -max_len=4096 -max_total_time=60 SCRATCH
//         tests/proof/fuzz/corpus
//
// New inputs go to the first folder, so a scratch folder comes first.
#include "common/scene.h"

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#define NAME "fuzz.nff"

// A longer input only repeats the cases of one line.
enum { LONGEST_INPUT = 1 << 16 };

#define MUST(holds)                                                                                \
    do {                                                                                           \
        if (!(holds)) {                                                                            \
            fprintf(stderr, "%s:%d: not true: %s\n", __FILE__, __LINE__, #holds);                  \
            abort();                                                                               \
        }                                                                                          \
    } while (0)

static void check_color(Color color)
{
    for (int i = 0; i < 3; i++)
        MUST(color[i] >= 0 && color[i] <= 1);
}

static void check_viewpoint(const Viewpoint *view)
{
    MUST(vec3_is_finite(view->from) && vec3_is_finite(view->at) && vec3_is_finite(view->up));
    MUST(view->angle > 0 && view->angle < 180);
    MUST(view->resolution.width >= 1 && view->resolution.width <= IMAGE_MAX_SIDE);
    MUST(view->resolution.height >= 1 && view->resolution.height <= IMAGE_MAX_SIDE);
}

// A scene with this number of lines: each holds at most one thing.
static void check_scene(const Scene *scene, int lines)
{
    check_viewpoint(&scene->view);
    check_color(scene->background);
    MUST(scene->sphere_count >= 0 && scene->light_count >= 0 && scene->surface_count >= 1);
    MUST(scene->sphere_count + scene->light_count + scene->surface_count - 1 + 6 <= lines);
    int surface = 0;
    for (int i = 0; i < scene->sphere_count; i++) {
        const Sphere *sphere = &scene->spheres[i];
        MUST(vec3_is_finite(sphere->center));
        MUST(isfinite(sphere->radius) && sphere->radius > 0);
        MUST(sphere->surface >= surface && sphere->surface < scene->surface_count);
        surface = sphere->surface;
    }
    for (int i = 0; i < scene->surface_count; i++) {
        const Surface *s = &scene->surfaces[i];
        check_color(s->color);
        MUST(isfinite(s->diffuse) && isfinite(s->specular) && isfinite(s->shine));
        MUST(isfinite(s->transmittance) && isfinite(s->refraction));
    }
    for (int i = 0; i < scene->light_count; i++) {
        MUST(vec3_is_finite(scene->lights[i].position));
        check_color(scene->lights[i].color);
    }
}

// One line of plain characters, that begins so. Returns what follows.
static const char *check_line(const char *text, const char *start)
{
    MUST(strncmp(text, start, strlen(start)) == 0);
    MUST(strlen(text) > strlen(start));
    for (const char *c = text; *c != '\0'; c++)
        MUST(*c >= ' ' && *c <= '~');
    return text + strlen(start);
}

static void check_message(const Message *message, int lines)
{
    const char *number = check_line(message->text, NAME ":");
    MUST(*number >= '1' && *number <= '9');
    char *end;
    long line = strtol(number, &end, 10);
    MUST(line <= lines);
    MUST(strncmp(end, ": ", 2) == 0 && strlen(end) > 2);
}

static bool is_empty(const Scene *scene)
{
    return scene->spheres == NULL && scene->surfaces == NULL && scene->lights == NULL &&
           scene->sphere_count == 0 && scene->surface_count == 0 && scene->light_count == 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size > LONGEST_INPUT)
        return -1; // not for the corpus
    int lines = 1;
    for (size_t i = 0; i < size; i++)
        lines += data[i] == '\n';

    // Some C libraries refuse an empty buffer; a file without bytes is then /dev/null.
    FILE *file =
        size > 0 ? fmemopen((void *)(uintptr_t)data, size, "rb") : fopen("/dev/null", "rb");
    if (file == NULL)
        return 0;
    Scene scene;
    Message message, warning;
    memset(&message, 0, sizeof message);
    memset(&warning, 0xff, sizeof warning);
    bool good = scene_read(file, NAME, &scene, &message, &warning);
    fclose(file);
    if (good)
        check_scene(&scene, lines);
    else
        check_message(&message, lines);
    if (warning.text[0] != '\0')
        check_line(warning.text, NAME ": warning: ");
    if (!good)
        MUST(is_empty(&scene));
    scene_free(&scene);
    MUST(is_empty(&scene));
    return 0;
}
