// story.c - headings and labelled lines.
#include "common/story.h"

#include "common/answers.h"
#include "common/options.h"
#include "common/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

bool story_is_for_page;
static const char *functions_of_line;

void story_by(const char *functions)
{
    functions_of_line = functions;
}

void story_heading(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    printf("\n");
    vprintf(format, arguments);
    printf("\n");
    va_end(arguments);
}

void story_line(const char *label, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    printf(story_is_for_page ? "%s\t" : "  %-27s ", label);
    vprintf(format, arguments);
    if (story_is_for_page)
        printf("\t%s", functions_of_line != NULL ? functions_of_line : "");
    functions_of_line = NULL;
    printf("\n");
    va_end(arguments);
}

void story_segment(const char *name, vec3 from, vec3 to)
{
    if (story_is_for_page)
        printf("\t%s %.17g %.17g %.17g %.17g %.17g %.17g\n", name, from[0], from[1], from[2], to[0],
               to[1], to[2]);
}

void story_camera(Camera c)
{
    story_line("eye       p", "%s", vec3_text(c.origin).s);
    story_line("right     r", "%s", vec3_text(c.right).s);
    story_line("up        u", "%s", vec3_text(c.up).s);
    story_line("forward   f", "%s", vec3_text(c.forward).s);
    story_line("distance  d", "%s", number_text(c.distance).s);
    story_line("width     w", "%s", number_text(c.width).s);
    story_line("height    h", "%s", number_text(c.height).s);
}

int story_end(void)
{
    return answers_report();
}

void story_needs_camera(const char *program, Camera camera)
{
    CameraFault fault = camera_check(camera);
    if (fault == CAMERA_OK)
        return;
    fflush(stdout);
    fprintf(stderr, "%s: this is not a camera: %s\n", program, camera_fault_text(fault));
    exit(EXIT_COULD_NOT);
}
