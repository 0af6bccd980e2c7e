// rectangles.c - where the spheres of a scene are on the screen, in numbers.
#include "chapters/08-fast/rectangles.h"

#include "chapters/shared/example.h"
#include "common/answers.h"
#include "common/story.h"
#include "common/text.h"
#include "exercises/08-fast.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MOST_SHOWN = 12 };

// How many of count pixels have their middle between two points.
static double middles(double from, double to, int count)
{
    double first = fmax(ceil(from - 0.5), 0), last = fmin(floor(to - 0.5), count - 1);
    return last >= first ? last - first + 1 : 0;
}

static double pixels_in(ScreenRectangle box, Resolution screen)
{
    return middles(box.left, box.right, screen.width) * middles(box.top, box.bottom, screen.height);
}

static void tell(const Drawing *drawing)
{
    const Scene *scene = &drawing->scene;
    Resolution size = drawing->size;
    double asked = 0;
    const char *slash = strrchr(drawing->scene_path, '/');
    printf("08-fast: the rectangle of each sphere of %s\n",
           slash != NULL ? slash + 1 : drawing->scene_path);
    story_heading("On a screen of %d x %d pixels", size.width, size.height);
    printf("  sphere %10s %10s %10s %10s %12s\n", "left", "right", "top", "bottom", "pixels");
    for (int i = 0; i < scene->sphere_count; i++) {
        ScreenRectangle box = sphere_rectangle(drawing->camera, size, scene->spheres[i]);
        asked += pixels_in(box, size);
        if (i < MOST_SHOWN)
            printf("  %-6d %10s %10s %10s %10s %12.0f\n", i, number_text(box.left).s,
                   number_text(box.right).s, number_text(box.top).s, number_text(box.bottom).s,
                   pixels_in(box, size));
    }
    if (scene->sphere_count > MOST_SHOWN)
        printf("  ... and %d more\n", scene->sphere_count - MOST_SHOWN);
    double all = (double)size.width * size.height * scene->sphere_count;
    story_heading("May this ray hit that sphere?");
    printf("  every pixel asks every sphere      %14.0f questions\n", all);
    printf("  every sphere asks its rectangle    %14.0f questions, %s %%\n", asked,
           number_text_to(all > 0 ? 100 * asked / all : 0, 3).s);
}

int rectangles_tell(const char *program, const Command *command)
{
    static Drawing drawing;
    sphere_rectangle(example_camera(), (Resolution){1, 1}, (Sphere){.radius = 1});
    if (answers_report() != 0 ||
        !drawing_prepare(&drawing, program, command, "chapters/06-ray-casting/three-spheres.nff"))
        return EXIT_COULD_NOT;
    tell(&drawing);
    scene_free(&drawing.scene);
    return story_end();
}

int rectangles_command(int argc, char **argv)
{
    Command command = {0};
    RectangleFigure figure = {0};
    bool rectangles; // without the engines, there is nothing else to print
    const Option options[] = {
        {"size", 's', "WIDTHxHEIGHT", option_size, &command.size,
         "of the screen (as in the scene)"},
        {"rectangles", 0, NULL, option_flag, &rectangles, "the same: this is all that is here"},
        RECTANGLE_FIGURE_OPTIONS(figure),
        {0}};
    Usage usage = {
        "[OPTION]... [SCENE.nff]",
        "Prints the rectangle of each sphere on the screen. Without a scene: the deck's\n"
        "three spheres."};
    int first = options_read(argc, argv, options, usage);
    if (argc - first > 1)
        options_wrong(argv[0], "%d scenes, expected one", argc - first);
    command.scene_path = argv[first];
    return figure.command.name != NULL ? rectangle_figure(argv[0], &figure, &command)
                                       : rectangles_tell(argv[0], &command);
}
