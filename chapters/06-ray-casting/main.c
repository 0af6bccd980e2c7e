// main.c - chapter 06: the picture.
//
// Casts a scene, pixel by pixel (image order) or sphere by sphere (object order). Without arguments
// it casts the deck's three spheres, and also sketches them on the terminal. With --explain it
// explains one pixel instead; with --figure it prints the script of a figure.
#include "chapters/06-ray-casting/cast_spheres.h"
#include "chapters/06-ray-casting/explain.h"
#include "chapters/06-ray-casting/figures/figures.h"
#include "chapters/shared/needed_answers.h"
#include "chapters/shared/scene_command.h"
#include "common/answers.h"
#include "common/story.h"
#include "common/text.h"
#include "exercises/06-ray-casting.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool option_order(const char *text, void *into)
{
    *(Order *)into = strcmp(text, "object") == 0 ? OBJECT_ORDER : IMAGE_ORDER;
    return strcmp(text, "object") == 0 || strcmp(text, "image") == 0;
}

static bool cast(Drawing *drawing, Order order)
{
    Resolution size = drawing->image.size;
    if (order == IMAGE_ORDER) {
        cast_image_order(&drawing->scene, drawing->camera, &drawing->image);
        return true;
    }
    double *depth = malloc(sizeof *depth * (size_t)size.width * (size_t)size.height);
    if (depth == NULL) {
        fprintf(stderr, "%s: no memory for the depth of %d x %d pixels\n", drawing->program,
                size.width, size.height);
        return false;
    }
    cast_object_order(&drawing->scene, drawing->camera, &drawing->image, depth);
    free(depth);
    return true;
}

// The picture in letters: A is the first sphere of the scene, B the second, and so on.
static void sketch(const Drawing *drawing)
{
    enum { WIDTH = 64, HEIGHT = 24 };
    int spheres[WIDTH * HEIGHT];
    story_heading("What each ray hits first, by %d x %d rays", WIDTH, HEIGHT);
    if (!cast_spheres(&drawing->scene, drawing->camera, (Resolution){WIDTH, HEIGHT}, spheres))
        return;
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        printf("%s%c%s", i % WIDTH == 0 ? "  " : "", spheres[i] < 0 ? '.' : 'A' + spheres[i] % 26,
               i % WIDTH == WIDTH - 1 ? "\n" : "");
}

static void tell(const Drawing *drawing)
{
    const Scene *scene = &drawing->scene;
    printf("06-ray-casting: the picture\n");
    const char *slash = strrchr(drawing->scene_path, '/');
    story_heading("The camera of %s", slash != NULL ? slash + 1 : drawing->scene_path);
    story_camera(drawing->camera);
    story_heading("Its %d spheres", scene->sphere_count);
    for (int i = 0; i < scene->sphere_count && i < 8; i++)
        printf("  %c  center %-16s radius %-8s color %s\n", 'A' + i,
               vec3_text(scene->spheres[i].center).s, number_text(scene->spheres[i].radius).s,
               vec3_text(scene_surface(scene, i)->color).s);
    sketch(drawing);
}

// A question about one pixel, instead of the picture.
typedef struct {
    Pixel explained, pixel; // column -1: not given
    vec3 center;            // NaN: not given
    FigureCommand figure;
} Question;

static bool center_is_given(Question question)
{
    return !isnan(question.center[0]);
}

static int answer(const char *program, Command command, Question question)
{
    static Drawing drawing;
    bool figure = question.figure.name != NULL;
    Pixel pixel = question.explained.column >= 0 ? question.explained : question.pixel;
    if (command.output != NULL)
        options_wrong(program, "-o: no picture is drawn with %s",
                      figure ? "--figure" : "--explain");
    if (!picture_needs_are_met(IMAGE_ORDER) ||
        !drawing_prepare(&drawing, program, &command,
                         figure_scene(figure ? question.figure.name : "")))
        return EXIT_COULD_NOT;
    Resolution size = drawing.size;
    if (figure && pixel.column < 0 && command.scene_path == NULL && command.size.width == 0)
        pixel = figure_pixel(question.figure.name);
    if (pixel.column >= size.width || pixel.row >= size.height)
        options_wrong(program, "%s: (%d, %d) is not in a picture of %d x %d pixels",
                      question.explained.column >= 0 ? "--explain" : "--pixel", pixel.column,
                      pixel.row, size.width, size.height);
    if (center_is_given(question) && drawing.scene.sphere_count == 0)
        options_wrong(program, "--center: the scene has no sphere");
    if (center_is_given(question))
        drawing.scene.spheres[0].center = question.center;
    Shot shot = {&drawing.scene, drawing.camera, size, pixel};
    int status = figure ? casting_figure(program, question.figure, shot)
                        : explain(&shot, drawing.scene_path);
    scene_free(&drawing.scene);
    return status;
}

int main(int argc, char **argv)
{
    Command command = {0};
    Order order = IMAGE_ORDER;
    Question question = {.explained = {-1, -1}, .pixel = {-1, -1}, .center = {NAN, NAN, NAN}};
    const Option options[] = {
        COMMAND_OPTIONS(command),
        {"order", 0, "image|object", option_order, &order, "the outer loop (image)"},
        {"explain", 0, "COLUMN,ROW", option_pixel, &question.explained,
         "explain one pixel, in numbers, instead"},
        {"pixel", 0, "COLUMN,ROW", option_pixel, &question.pixel,
         "the pixel whose ray a figure shows"},
        {"center", 0, "X,Y,Z", option_vec3, &question.center,
         "another center for the first sphere of a figure"},
        FIGURE_OPTIONS(question.figure),
        {0}};
    Usage usage = {"[OPTION]... [SCENE.nff]",
                   "Draws a scene in flat colors. Without arguments: the deck's three spheres."};
    int first = options_read(argc, argv, options, usage);
    if (argc - first > 1)
        options_wrong(argv[0], "%d scenes, expected one", argc - first);
    command.scene_path = argv[first];
    if (question.figure.name != NULL || question.explained.column >= 0)
        return answer(argv[0], command, question);
    if (question.pixel.column >= 0)
        options_wrong(argv[0], "--pixel belongs to --figure; did you mean --explain?");
    if (center_is_given(question))
        options_wrong(argv[0], "--center belongs to --figure or --explain");

    static Drawing drawing;
    if (!picture_needs_are_met(order) ||
        !drawing_begin(&drawing, argv[0], &command, "chapters/06-ray-casting/three-spheres.nff"))
        return EXIT_COULD_NOT;
    if (argc == 1)
        tell(&drawing);
    if (!cast(&drawing, order))
        return EXIT_COULD_NOT;
    int status = drawing_end(&drawing);
    if (status == EXIT_DONE && command.output == NULL)
        printf("%s%s\n", argc == 1 ? "\nThe picture: " : "", drawing.output);
    return status;
}
