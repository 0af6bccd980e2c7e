// scene.h - for the tests of scenes: a text as a scene, or refused in which line, and why.
#ifndef TESTS_COMMON_SCENE_H
#define TESTS_COMMON_SCENE_H

#include "common/scene.h"
#include "tests/judge/test.h"

#include <stdio.h>
#include <string.h>

// A viewpoint, 6 lines, and a sphere in line 7.
#define VIEW "v\nfrom 1 2 3\nat 4 5 6\nup 0 1 0\nangle 45\nresolution 64 48\n"
#define SPHERE "s 1 2 3 4\n"

static Message message, warning;

// Reads size bytes as a scene of the name scene.nff.
static inline bool read_bytes(const char *bytes, size_t size, Scene *scene)
{
    FILE *file = tmpfile();
    ck_assert_ptr_nonnull(file);
    ck_assert_uint_eq(fwrite(bytes, 1, size, file), size);
    rewind(file);
    strcpy(message.text, "");
    strcpy(warning.text, "nothing was said");
    bool good = scene_read(file, "scene.nff", scene, &message, &warning);
    fclose(file);
    return good;
}

// To be freed.
static inline Scene scene_of(const char *text)
{
    Scene scene;
    given("scene", "%.300s", text);
    expect_law(read_bytes(text, strlen(text), &scene), "a scene", "%s", message.text);
    return scene;
}

static inline void expect_refused_bytes(const char *bytes, size_t size, int line, const char *words)
{
    Scene scene;
    char start[30];
    snprintf(start, sizeof start, "scene.nff:%d: ", line);
    given("scene", "%.300s", bytes);
    expect_law(!read_bytes(bytes, size, &scene), "refused", "a scene");
    given("scene", "%.300s", bytes);
    expect_law(strncmp(message.text, start, strlen(start)) == 0, start, "%s", message.text);
    given("scene", "%.300s", bytes);
    expect_law(strstr(message.text, words) != NULL, words, "%s", message.text);
    // It is empty, and freeing it is harmless.
    ck_assert(scene.spheres == NULL && scene.surfaces == NULL && scene.lights == NULL);
    expect_int(scene.sphere_count + scene.surface_count + scene.light_count, 0);
    scene_free(&scene);
}

// This line, and words that its message must have.
static inline void expect_refused(const char *text, int line, const char *words)
{
    expect_refused_bytes(text, strlen(text), line, words);
}

#endif
