// check_example.c - says what is wrong with the numbers of chapters/example.h, before anything is
// made of them. Exit status 1 if they are not an example.
#include "chapters/shared/example.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

__attribute__((format(printf, 1, 2), noreturn)) static void wrong_example(const char *format, ...)
{
    va_list list;
    va_start(list, format);
    fprintf(stderr, "chapters/example.h: ");
    vfprintf(stderr, format, list);
    fprintf(stderr, "\n");
    va_end(list);
    exit(1);
}

int main(void)
{
    CameraFault fault = camera_check(example_camera());
    Normalized place = example_place();
    Resolution screen = example_screen();
    Pixel pixel = example_pixel();
    Ray ray = example_ray();
    Sphere sphere = example_sphere();
    if (fault != CAMERA_OK)
        wrong_example("this is not a camera: %s", camera_fault_text(fault));
    if (!(place.s >= 0 && place.s <= 1 && place.t >= 0 && place.t <= 1))
        wrong_example("EXAMPLE_PLACE: expected two numbers from 0 to 1");
    if (screen.width < 1 || screen.height < 1)
        wrong_example("EXAMPLE_SCREEN: expected at least 1 x 1 pixels");
    if (pixel.column < 0 || pixel.row < 0 || pixel.column >= screen.width ||
        pixel.row >= screen.height)
        wrong_example("EXAMPLE_POINT: (%d, %d) is not a pixel of a screen of %d x %d", pixel.column,
                      pixel.row, screen.width, screen.height);
    // The middle of the chord is ahead, p is outside, and the line passes closer than the radius.
    vec3 to_center = sphere.center - ray.origin, unit = vec3_unit(ray.direction);
    double ahead = vec3_dot(to_center, unit), away = vec3_length(to_center - ahead * unit);
    if (!(sphere.radius > 0 && ahead > 0 && vec3_length(to_center) > sphere.radius &&
          away < sphere.radius))
        wrong_example("the ray does not meet the sphere twice in front of EXAMPLE_RAY_ORIGIN");
    return 0;
}
