// odd_questions.c - questions that a hostile answer asks the judge for what is lent: each argument
// of each exercise with numbers that nobody asks for. The reference must come back from all of
// them.
//
//   odd_questions       says 'odd questions: N passed, N failed'; a crash is the failure
#include "common/scene.h"
#include "common/screen.h"
#include "exercises/02-cameras.h"
#include "exercises/05-quadratic.h"
#include "tests/judge/message.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { QUESTIONS = 4000 }; // of each exercise

static uint64_t state = 2015;

static unsigned draw(unsigned below)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (unsigned)(state >> 33) % below;
}

static double odd_double(void)
{
    static const double odd[] = {0,       -0.0,     NAN,     INFINITY, -INFINITY,
                                 DBL_MAX, -DBL_MAX, DBL_MIN, 5e-324,   1e9};
    return draw(3) != 0 ? (double)draw(2000) / 100 - 10 : odd[draw(sizeof odd / sizeof odd[0])];
}

static int odd_int(int most)
{
    static const int odd[] = {-1,  INT_MIN, INT_MAX, 1 << 30, 1 << 28,
                              100, 101,     16384,   16385,   65536};
    return draw(3) != 0 ? (int)draw((unsigned)most + 1) : odd[draw(sizeof odd / sizeof odd[0])];
}

// A struct is doubles, but for the numbers at the end of it that are set afterwards.
static void odd_doubles(void *value, size_t size)
{
    for (size_t at = 0; at + sizeof(double) <= size; at += sizeof(double)) {
        double x = odd_double();
        memcpy((char *)value + at, &x, sizeof x);
    }
}

#define ODD(type, name)                                                                            \
    type name;                                                                                     \
    odd_doubles(&name, sizeof name)

static void put_int(Wire *wire, int value)
{
    wire_put(wire, &value, sizeof value);
}

static void put_sphere(Wire *wire)
{
    ODD(Sphere, sphere);
    sphere.surface = odd_int(3);
    wire_put(wire, &sphere, sizeof sphere);
}

static void put_light(Wire *wire)
{
    ODD(Light, light);
    int kind = odd_int(1);
    memcpy(&light.kind, &kind, sizeof kind);
    wire_put(wire, &light, sizeof light);
}

static void put_scene(Wire *wire)
{
    ODD(Scene, scene);
    wire_put(wire, &scene.view, sizeof scene.view);
    wire_put(wire, &scene.background, sizeof scene.background);
    wire_put(wire, &scene.ambient, sizeof scene.ambient);
    int there = (int)draw(5);
    put_int(wire, draw(8) != 0 ? there : odd_int(5));
    for (int i = 0; i < there; i++)
        put_sphere(wire);
    put_int(wire, draw(8) != 0 ? 4 : odd_int(5));
    for (int i = 0; i < 4; i++) {
        ODD(Surface, surface);
        wire_put(wire, &surface, sizeof surface);
    }
    there = (int)draw(4);
    put_int(wire, draw(8) != 0 ? there : odd_int(4));
    for (int i = 0; i < there; i++)
        put_light(wire);
}

// A picture with that many pixels, or one that only claims so.
static size_t put_image(Wire *wire)
{
    Resolution size = {(int)draw(9), (int)draw(9)}, said = size;
    if (draw(4) == 0)
        said = (Resolution){odd_int(9), odd_int(9)};
    size_t pixels = (size_t)size.width * (size_t)size.height;
    static const uint8_t zeros[3 * 81];
    wire_put(wire, &said, sizeof said);
    wire_put(wire, zeros, 3 * pixels);
    return pixels;
}

static void put(Wire *wire, const char *type, size_t length, size_t *pixels)
{
#define IS(name) (length == strlen(name) && strncmp(type, name, length) == 0)
#define PUT_DOUBLES(name)                                                                          \
    if (IS(#name)) {                                                                               \
        ODD(name, value);                                                                          \
        wire_put(wire, &value, sizeof value);                                                      \
        return;                                                                                    \
    }
    PUT_DOUBLES(double)
    PUT_DOUBLES(vec3)
    PUT_DOUBLES(Ray)
    PUT_DOUBLES(ScreenPoint)
    PUT_DOUBLES(Normalized)
    PUT_DOUBLES(Quadratic)
    PUT_DOUBLES(Camera)
    PUT_DOUBLES(LookAt)
    PUT_DOUBLES(Corners)
    if (IS("int"))
        put_int(wire, odd_int(4));
    else if (IS("Handedness"))
        put_int(wire, odd_int(1));
    else if (IS("Resolution") || IS("Pixel")) {
        put_int(wire, odd_int(640));
        put_int(wire, odd_int(480));
    } else if (IS("Hit")) {
        ODD(Hit, hit);
        hit.sphere = odd_int(4);
        wire_put(wire, &hit, sizeof hit);
    } else if (IS("Sphere"))
        put_sphere(wire);
    else if (IS("Light"))
        put_light(wire);
    else if (IS("Scene"))
        put_scene(wire);
    else if (IS("Image"))
        *pixels = put_image(wire);
    else if (IS("Doubles")) {
        for (size_t i = 0; i < *pixels; i++) {
            double x = odd_double();
            wire_put(wire, &x, sizeof x);
        }
    } else {
        fprintf(stderr, "%.*s: a type that is not asked here\n", (int)length, type);
        exit(1);
    }
}

int main(void)
{
    Wire question = {0}, answer = {0};
    int asked = 0, answered = 0, failed = 0;
    for (int i = 0; exercises[i].name != NULL; i++) {
        int answers = 0;
        for (int n = 0; n < QUESTIONS; n++) {
            wire_clear(&question);
            wire_clear(&answer);
            size_t pixels = 0;
            for (const char *type = exercises[i].arguments; *type != '\0';) {
                size_t length = strcspn(type, " ");
                put(&question, type, length, &pixels);
                type += length + (type[length] == ' ');
            }
            question.is_hostile = true;
            asked++;
            answers += apply(i, exercises[i].reference, &question, &answer);
        }
        if (answers == 0) {
            printf("not ok: %s answers none of these questions\n", exercises[i].name);
            failed++;
        }
        answered += answers > 0;
    }
    wire_free(&question);
    wire_free(&answer);
    printf("odd questions: asked %d\n", asked);
    printf("odd questions: %d passed, %d failed\n", answered, failed);
    return failed == 0 ? 0 : 1;
}
