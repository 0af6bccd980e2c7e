// given.c - what goes into a test, in words for its reader.
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

void camera_words(char *words, size_t size, Camera c, int digits)
{
    snprintf(words, size, "eye~%s, right~%s, up~%s, forward~%s, d~%s, w~%s, h~%s",
             vec3_text_to(c.origin, digits).s, vec3_text_to(c.right, digits).s,
             vec3_text_to(c.up, digits).s, vec3_text_to(c.forward, digits).s,
             number_text_to(c.distance, digits).s, number_text_to(c.width, digits).s,
             number_text_to(c.height, digits).s);
}

void given_camera(Camera camera)
{
    char words[CAMERA_WORDS];
    camera_words(words, sizeof words, camera, 6);
    given("camera", "%s", words);
}

void given_ray(Ray ray)
{
    given("ray", "origin %s, direction %s", vec3_text_to(ray.origin, 10).s,
          vec3_text_to(ray.direction, 10).s);
}

void given_sphere(Sphere sphere)
{
    given("sphere", "center %s, radius %s", vec3_text_to(sphere.center, 10).s,
          number_text_to(sphere.radius, 10).s);
}
