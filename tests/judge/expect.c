// expect.c - the expected result of a test, and both sides in words if they differ.
#include "tests/judge/record.h"
#include "tests/judge/test.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

// Met: the next given begins a new case. Not met: both sides are kept and the test ends.
static void settle(bool met, const char *yours, const char *expected)
{
    Record *record = record_now();
    if (met && !record_is_missing()) {
        record->closed = true;
        return;
    }
    record_keep_printed();
    snprintf(record->expected, sizeof record->expected, "%s", expected);
    snprintf(record->yours, sizeof record->yours, "%s", yours);
    ck_abort_msg("not as expected");
}

static bool near(double yours, double expected, double tolerance)
{
    return yours == expected || fabs(yours - expected) <= tolerance;
}

static bool vec3_near(vec3 yours, vec3 expected, double tolerance)
{
    return near(yours[0], expected[0], tolerance) && near(yours[1], expected[1], tolerance) &&
           near(yours[2], expected[2], tolerance);
}

// Enough digits to see that two numbers differ, if they do.
static int digits_that_tell(const double *yours, const double *expected, int count)
{
    int digits = 6;
    for (int i = 0; i < count; i++)
        while (digits < 17 && yours[i] != expected[i] &&
               strcmp(number_text_to(yours[i], digits).s, number_text_to(expected[i], digits).s) ==
                   0)
            digits++;
    return digits;
}

// One number, or several in parentheses, each below its counterpart.
static void settle_numbers(bool met, const double *yours, const double *expected, int count)
{
    char y[400] = "", e[400] = "";
    if (met) {
        settle(true, y, e);
        return;
    }
    int digits = digits_that_tell(yours, expected, count);
    size_t y_used = 0, e_used = 0;
    for (int i = 0; i < count; i++) {
        Text a = number_text_to(yours[i], digits), b = number_text_to(expected[i], digits);
        int wide = (int)(strlen(a.s) > strlen(b.s) ? strlen(a.s) : strlen(b.s));
        if (record_is_missing()) // then yours is not shown
            wide = 0;
        const char *before = count == 1 ? "" : i == 0 ? "(" : ", ";
        const char *behind = count > 1 && i == count - 1 ? ")" : "";
        snprintf(y + y_used, sizeof y - y_used, "%s%*s%s", before, wide, a.s, behind);
        snprintf(e + e_used, sizeof e - e_used, "%s%*s%s", before, wide, b.s, behind);
        y_used = strlen(y);
        e_used = strlen(e);
    }
    settle(false, y, e);
}

void expect_number(double yours, double expected, double tolerance)
{
    settle_numbers(near(yours, expected, tolerance), &yours, &expected, 1);
}

void expect_vec3(vec3 yours, vec3 expected, double tolerance)
{
    const double y[3] = {yours[0], yours[1], yours[2]};
    const double e[3] = {expected[0], expected[1], expected[2]};
    settle_numbers(vec3_near(yours, expected, tolerance), y, e, 3);
}

void expect_pair(double yours_x, double yours_y, double x, double y, double tolerance)
{
    bool met = near(yours_x, x, tolerance) && near(yours_y, y, tolerance);
    settle_numbers(met, (const double[]){yours_x, yours_y}, (const double[]){x, y}, 2);
}

void expect_value(const Type *type, const void *yours, const void *expected, double tolerance,
                  double size)
{
    bool met = type_near(type, yours, expected, tolerance, tolerance * size);
    char y[CAMERA_WORDS] = "", e[CAMERA_WORDS] = "";
    int digits = 6;
    while (!met && strcmp(y, e) == 0 && digits <= 17) {
        type_words(type, yours, digits, y, sizeof y);
        type_words(type, expected, digits++, e, sizeof e);
    }
    settle(met, y, e);
}

void expect_camera(Camera yours, Camera expected, double tolerance)
{
    expect_value(&type_Camera, &yours, &expected, tolerance, 1);
}

void expect_camera_of_size(Camera yours, Camera expected, double tolerance, double size)
{
    expect_value(&type_Camera, &yours, &expected, tolerance, size);
}

void expect_fault(CameraFault yours, CameraFault expected)
{
    settle(yours == expected, yours == CAMERA_OK ? "a camera" : camera_fault_text(yours),
           expected == CAMERA_OK ? "a camera" : camera_fault_text(expected));
}

void expect_int(long yours, long expected)
{
    char y[32], e[32];
    snprintf(y, sizeof y, "%ld", yours);
    snprintf(e, sizeof e, "%ld", expected);
    settle(yours == expected, y, e);
}

void expect_text(const char *yours, const char *expected)
{
    settle(strcmp(yours, expected) == 0, yours, expected);
}

void expect_same_ray(Ray yours, Ray expected, double tolerance)
{
    double length = vec3_length(yours.direction);
    vec3 scaled = vec3_length(expected.direction) / length * yours.direction;
    bool met = length > 0 && vec3_near(yours.origin, expected.origin, tolerance) &&
               vec3_near(scaled, expected.direction, tolerance);
    char y[400], e[400];
    snprintf(y, sizeof y, "origin %s, direction %s", vec3_text_to(yours.origin, 9).s,
             vec3_text_to(yours.direction, 9).s);
    snprintf(e, sizeof e, "origin %s, direction %s (or any positive multiple)",
             vec3_text_to(expected.origin, 9).s, vec3_text_to(expected.direction, 9).s);
    settle(met, y, e);
}

void expect_same_image(const Image *yours, const Image *expected)
{
    size_t pixels = (size_t)expected->size.width * (size_t)expected->size.height;
    size_t first = 0, different = 0;
    for (size_t i = pixels; i-- > 0;)
        if (memcmp(yours->rgb + 3 * i, expected->rgb + 3 * i, 3) != 0) {
            first = i;
            different++;
        }
    const uint8_t *y = yours->rgb + 3 * first, *e = expected->rgb + 3 * first;
    size_t width = (size_t)expected->size.width;
    char yw[200], ew[200];
    snprintf(ew, sizeof ew, "in column %zu, row %zu: red %d, green %d, blue %d", first % width,
             first / width, e[0], e[1], e[2]);
    snprintf(yw, sizeof yw,
             "in column %zu, row %zu: red %d, green %d, blue %d; %zu of %zu pixels "
             "differ",
             first % width, first / width, y[0], y[1], y[2], different, pixels);
    settle(different == 0, yw, ew);
}

void expect_law(bool holds, const char *expected, const char *format, ...)
{
    char yours[400];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(yours, sizeof yours, format, arguments);
    va_end(arguments);
    settle(holds, yours, expected);
}
