// lesson_example.c - the numbers of the lessons for another example: that of a figure in the page.
//
// Usage: numbers --figure=NAME [OPTION]..., with the figure's options. Prints {"NAME":
// "NUMBER", ...} for the numbers that differ from those of chapters/example.h. The linker puts
// __wrap_NAME in the place of the functions of chapters/shared/example.c (--wrap=NAME).
#include "chapters/lessons/numbers.h"
#include "chapters/shared/example.h"
#include "common/options.h"
#include "common/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct {
    Camera camera;
    Normalized place;
    double point[2];
    Pixel pixel;
    Ray ray;
    Sphere sphere;
} example;

#define EXAMPLE(type, name, value)                                                                 \
    type __real_example_##name(void), __wrap_example_##name(void);                                 \
    type __wrap_example_##name(void)                                                               \
    {                                                                                              \
        return value;                                                                              \
    }
EXAMPLE(Camera, camera, example.camera)
EXAMPLE(Normalized, place, example.place)
EXAMPLE(ScreenPoint, point, ((ScreenPoint){example.point[0], example.point[1]}))
EXAMPLE(Pixel, pixel, example.pixel)
EXAMPLE(Ray, ray, example.ray)
EXAMPLE(Sphere, sphere, example.sphere)

// The pixel that a point is in, as in chapters/03-screen/main.c; or the point where a pixel begins.
static void complete(void)
{
    Resolution screen = example_screen();
    double x = example.point[0], y = example.point[1];
    if (!isnan(x))
        example.pixel = (Pixel){(int)fmax(0, fmin(floor(x), screen.width - 1)),
                                (int)fmax(0, fmin(floor(y), screen.height - 1))};
    else if (example.pixel.column < 0)
        example.pixel = __real_example_pixel();
    if (isnan(x)) {
        example.point[0] = example.pixel.column;
        example.point[1] = example.pixel.row;
    }
}

// The figure that has these options. One has a small screen of its own: it is not the example.
static const char *figure;
static const char own_example[] = "pixel-grid";

static void read_example(int argc, char **argv)
{
    example.camera = __real_example_camera();
    example.place = __real_example_place();
    example.point[0] = example.point[1] = NAN;
    example.pixel = (Pixel){-1, -1};
    example.ray = __real_example_ray();
    example.sphere = __real_example_sphere();
    const Option options[] = {
        {"figure", 0, "NAME", option_string, &figure, "that has these options"},
        CAMERA_OPTIONS(example.camera),
        {"s", 's', "S", option_number, &example.place.s, "how far across the plane"},
        {"t", 't', "T", option_number, &example.place.t, "how far up the plane"},
        {"point", 0, "X,Y", option_pair, example.point, "on the screen"},
        {"pixel", 0, "COLUMN,ROW", option_pixel, &example.pixel, "of the screen"},
        {"origin", 0, "X,Y,Z", option_vec3, &example.ray.origin, "of the ray"},
        {"direction", 0, "X,Y,Z", option_vec3, &example.ray.direction, "of the ray"},
        {"center", 0, "X,Y,Z", option_vec3, &example.sphere.center, "of the sphere"},
        {"radius", 0, "R", option_number, &example.sphere.radius, "of the sphere"},
        {0}};
    Usage usage = {"[OPTION]...", "The numbers of the lessons for another example, as JSON."};
    if (options_read(argc, argv, options, usage) != argc)
        options_wrong(argv[0], "expected options only");
    complete();
}

int main(int argc, char **argv)
{
    read_example(1, argv);
    int count;
    const NamedNumber *numbers = named_numbers(&count);
    NamedNumber *lecture = malloc((size_t)count * sizeof *lecture);
    if (lecture == NULL)
        return 1;
    memcpy(lecture, numbers, (size_t)count * sizeof *lecture);
    read_example(argc, argv);
    named_numbers(&count);
    if (figure != NULL && strcmp(figure, own_example) == 0)
        count = 0;
    const char *before = "{";
    for (int i = 0; i < count; i++)
        if (strcmp(numbers[i].text, lecture[i].text) != 0) {
            fputs(before, stdout);
            json_print_string(stdout, numbers[i].name);
            fputs(": ", stdout);
            json_print_string(stdout, numbers[i].text);
            before = ",\n";
        }
    puts(*before == '{' ? "{}" : "}");
    return 0;
}
