// print_numbers.c - prints the numbers of the example as JSON: {"NAME": "TEXT", ...}; or of another
// one, given by the options of a figure, as a page does when the figure is dragged.
#include "chapters/lessons/numbers.h"
#include "chapters/shared/example.h"
#include "common/options.h"
#include "common/text.h"

#include <math.h>
#include <stdio.h>

// A point has the pixel that it is in, as in chapters/03-screen/main.c; a pixel, the point where it
// begins.
static void complete(Example *example, const double point[2])
{
    Resolution screen = example_screen();
    if (!isnan(point[0])) {
        example->point = (ScreenPoint){point[0], point[1]};
        example->pixel = (Pixel){(int)fmax(0, fmin(floor(point[0]), screen.width - 1)),
                                 (int)fmax(0, fmin(floor(point[1]), screen.height - 1))};
    } else
        example->point = (ScreenPoint){example->pixel.column, example->pixel.row};
}

static Example read_example(int argc, char **argv)
{
    Example example = {.camera = example_camera(),
                       .place = example_place(),
                       .pixel = example_pixel(),
                       .ray = example_ray(),
                       .sphere = example_sphere()};
    double point[2] = {NAN, NAN};
    const Option options[] = {
        CAMERA_OPTIONS(example.camera),
        {"s", 's', "S", option_number, &example.place.s, "how far across the plane"},
        {"t", 't', "T", option_number, &example.place.t, "how far up the plane"},
        {"point", 0, "X,Y", option_pair, point, "on the screen"},
        {"pixel", 0, "COLUMN,ROW", option_pixel, &example.pixel, "of the screen"},
        {"origin", 0, "X,Y,Z", option_vec3, &example.ray.origin, "of the ray"},
        {"direction", 0, "X,Y,Z", option_vec3, &example.ray.direction, "of the ray"},
        {"center", 0, "X,Y,Z", option_vec3, &example.sphere.center, "of the sphere"},
        {"radius", 0, "R", option_number, &example.sphere.radius, "of the sphere"},
        {0}};
    Usage usage = {"[OPTION]...", "The numbers of the lessons and slides, as JSON."};
    if (options_read(argc, argv, options, usage) != argc)
        options_wrong(argv[0], "expected options only");
    complete(&example, point);
    return example;
}

int main(int argc, char **argv)
{
    Example example = read_example(argc, argv);
    int count;
    const NamedNumber *numbers = named_numbers(&example, &count);
    for (int i = 0; i < count; i++) {
        printf(i == 0 ? "{" : ", ");
        json_print_string(stdout, numbers[i].name);
        printf(": ");
        json_print_string(stdout, numbers[i].text);
    }
    printf("}\n");
    return 0;
}
