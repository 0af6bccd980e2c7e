// given.c - the arguments of a test, in words for its reader.
#include "tests/judge/record.h"
#include "tests/judge/test.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

__attribute__((noinline)) void case_begins(int number)
{
    Record *record = record_now();
    record->cases = number;
    record->closed = false;
    record->given[0] = '\0';
}

void given(const char *name, const char *format, ...)
{
    Record *record = record_now();
    if (record->cases == 0 || record->closed)
        case_begins(record->cases + 1);
    char value[CAMERA_WORDS];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(value, sizeof value, format, arguments);
    va_end(arguments);
    size_t used = strlen(record->given);
    snprintf(record->given + used, sizeof record->given - used, "%s\t%s\n", name, value);
}

void given_number(const char *name, double x)
{
    given(name, "%s", number_text_to(x, 10).s);
}

void given_vec3(const char *name, vec3 v)
{
    given(name, "%s", vec3_text_to(v, 10).s);
}

void given_value(const char *name, const Type *type, const void *value, int digits)
{
    char words[CAMERA_WORDS];
    type_words(type, value, digits, words, sizeof words);
    given(name, "%s", words);
}

void given_camera(Camera camera)
{
    given_value("camera", &type_Camera, &camera, 6);
}

void given_ray(Ray ray)
{
    given_value("ray", &type_Ray, &ray, 10);
}

void given_sphere(Sphere sphere)
{
    given_value("sphere", &type_Sphere, &sphere, 10);
}

Camera camera_of_the_deck(void)
{
    return (Camera){.origin = vec3_of(2, 2, -4),
                    .right = vec3_of(1, 0, 0),
                    .up = vec3_of(0, 1, 0),
                    .forward = vec3_of(0, 0, 1),
                    .distance = 4,
                    .width = 2,
                    .height = 2};
}
