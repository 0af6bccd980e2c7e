// failed_check.c - a call that the toolkit cannot answer: the program ends, and says so.
#include "common/failed_check.h"

#include <stdio.h>
#include <stdlib.h>

void (*tell_failed_check)(const FailedCheck *failed);

// Pictures are made by several threads.
static _Thread_local const char *file = "";
static _Thread_local int line;

void called_in(const char *its_file, int its_line)
{
    file = its_file;
    line = its_line;
}

// The loop that calls, if only one loop calls like that.
static const char *loop_of_pixels(long column, long row, long width, long height, long before)
{
    if (column == 0 && row == height && before == width * height)
        return ": does a loop run up to row <= height?";
    if (column == width && before == width * row + width)
        return ": does a loop run up to column <= width?";
    return "";
}

void failed_check_text(const FailedCheck *failed, bool with_numbers, char *text, size_t size)
{
    const long *n = failed->numbers;
    if (failed->kind == CHECKED_PIXEL) {
        const char *loop = loop_of_pixels(n[0], n[1], n[2], n[3], n[4]);
        if (with_numbers)
            snprintf(text, size, "image_set: column %ld, row %ld is not in an image of %ld x %ld%s",
                     n[0], n[1], n[2], n[3], loop);
        else
            snprintf(text, size, "image_set: a pixel that is not in the image%s", loop);
    } else {
        const char *loop = n[0] == n[1] ? ": does a loop run up to i <= sphere_count?"
                           : n[0] == -1 ? ": -1 is the sphere of a ray that hits nothing"
                                        : "";
        if (with_numbers)
            snprintf(text, size, "scene_surface: sphere %ld does not exist in a scene of %ld%s",
                     n[0], n[1], loop);
        else
            snprintf(text, size, "scene_surface: a sphere that does not exist%s", loop);
    }
}

_Noreturn void check_failed(CheckKind kind, const long numbers[5])
{
    char text[200];
    FailedCheck failed = {.kind = (int)kind, .line = line};
    for (int i = 0; i < 5; i++)
        failed.numbers[i] = numbers[i];
    if (tell_failed_check != NULL)
        tell_failed_check(&failed);
    failed_check_text(&failed, true, text, sizeof text);
    fprintf(stderr, "%s:%d: %s\n", file, line, text);
    abort();
}
