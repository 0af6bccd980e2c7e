// main.c - chapter 08: the same picture, faster; and where spheres are on the screen. Chooses an
// engine, draws a scene with it, flat or shaded, and prints how long that took.
//
// The students' archive does not have the engines, because they contain answers to earlier
// chapters, and a page has no threads. There the program only has the rectangles; so has the one
// that prints the figure, which is needed before any engine is (chapter.mk).
#include "chapters/08-fast/rectangles.h"

#if !__has_include("chapters/08-fast/engines/engine.h") || defined __wasm__ ||                     \
                   defined WITHOUT_ENGINES
int main(int argc, char **argv)
{
    return rectangles_command(argc, argv);
}
#else
#include "chapters/08-fast/engines/engine.h"
#include "chapters/shared/lighting.h"
#include "chapters/shared/needed_answers.h"
#include "common/clock.h"
#include "common/text.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

static const Engine *chosen; // the engine

static void use_plain(void)
{
    fprintf(stderr, "%s: the scene has extreme numbers (see --help), so plain casts it\n",
            chosen->name);
    chosen = &engines[0];
}

static bool option_engine(const char *text, void *into)
{
    *(const Engine **)into = engine_named(text);
    return *(const Engine **)into != NULL || strcmp(text, "auto") == 0;
}

static bool option_threads(const char *text, void *into)
{
    return option_whole(text, 1, 256, into);
}

static void list_engines(void)
{
    printf("08-fast: the same picture, faster\n\n");
    for (const Engine *engine = engines; engine->name != NULL; engine++)
        printf("  %-8s %s\n", engine->name, engine->idea);
    printf("\n");
}

static void say_what_it_took(const char *name, const Drawing *drawing, bool shaded, double seconds)
{
    Resolution size = drawing->image.size;
    fprintf(stderr, "%s: %d x %d %s among %d spheres in %s", name, size.width, size.height,
            shaded ? "pixels, shaded," : "rays", drawing->scene.sphere_count,
            duration_text(seconds).s);
    if (!shaded)
        fprintf(stderr, ", %s million a second",
                number_text_to(1e-6 * size.width * size.height / seconds, 3).s);
    fprintf(stderr, "\n");
}

int main(int argc, char **argv)
{
    Command command = {0};
    int threads = 1;
    bool shaded = false, rectangles = false;
    Lighting lighting = lighting_untold;
    RectangleFigure figure = {0};
    const Option options[] = {
        COMMAND_OPTIONS(command),
        {"engine", 'e', "NAME", option_engine, &chosen,
         "plain, object, bvh, packet, tiles, bins (auto)"},
        {"threads", 't', "N", option_threads, &threads, "number of threads, 1 to 256 (1)"},
        {"shaded", 0, NULL, option_flag, &shaded, "with shadows and mirrors: plain, bvh (auto)"},
        LIGHTING_OPTIONS(lighting),
        {"turn", 0, "DEGREES", option_number, &command.turn,
         "go around the scene before looking at it (0)"},
        {"rectangles", 0, NULL, option_flag, &rectangles,
         "only print the rectangle of each sphere"},
        RECTANGLE_FIGURE_OPTIONS(figure),
        {0}};
    Usage usage = {
        "[OPTION]... [SCENE.nff]",
        "Draws a scene, flat or shaded, with one of six engines. Without arguments it lists the\n"
        "engines, and draws the deck's three spheres. If a sphere is more than 1e12 of its radii\n"
        "away (with --shaded: 1e10 of the smallest radius), a pixel is narrower than 1e-13 of its\n"
        "distance, or a length is above 1e60 or below 1e-60, plain casts the scene instead."};
    int first = options_read(argc, argv, options, usage);
    if (argc - first > 1)
        options_wrong(argv[0], "%d scenes, expected one", argc - first);
    lighting_check(&lighting, argv[0]);
    if (!shaded && lighting_is_told(&lighting))
        options_wrong(argv[0],
                      "light changes nothing in a flat picture, expected --shaded as well");
    // Building a hierarchy takes longer than casting with bins, and a picture is cast only once.
    // But rays from mirrors start everywhere, and need a hierarchy.
    if (chosen == NULL)
        chosen = engine_named(shaded ? "bvh" : "bins");
    if (shaded && chosen->light == NULL)
        options_wrong(argv[0], "%s has no shadows and no mirrors, expected plain or bvh",
                      chosen->name);
    command.scene_path = argv[first];
    if (rectangles && command.output != NULL)
        options_wrong(argv[0], "-o: no picture is drawn with --rectangles");
    if (figure.command.name != NULL)
        return rectangle_figure(argv[0], &figure, &command);
    if (rectangles)
        return rectangles_tell(argv[0], &command);

    static Drawing drawing;
    if (!(shaded ? shading_needs_are_met(lighting.style) : picture_needs_are_met(IMAGE_ORDER)) ||
        !drawing_begin(&drawing, argv[0], &command, "chapters/06-ray-casting/three-spheres.nff"))
        return EXIT_COULD_NOT;
    if (argc == 1)
        list_engines();
    if (!lighting_apply(&lighting, &drawing.scene)) {
        fprintf(stderr, "%s: no memory for a light\n", argv[0]);
        return EXIT_COULD_NOT;
    }
    double began = clock_seconds(), built = began;
    Work work = {&drawing.scene, drawing.camera, &drawing.image, threads, &built, use_plain};
    if (shaded && chosen != &engines[0] && extreme_light(&work))
        use_plain();
    Message message;
    if (shaded ? !chosen->light(&work, lighting.style, &message) : !chosen->cast(&work, &message)) {
        fprintf(stderr, "%s: %s\n", argv[0], message.text);
        return EXIT_COULD_NOT;
    }
    double took = clock_seconds() - built;
    drawing_is_done();
    if (built > began)
        fprintf(stderr, "%s: built in %s\n", chosen->name, duration_text(built - began).s);
    say_what_it_took(chosen->name, &drawing, shaded, took);
    int status = drawing_end(&drawing);
    if (status == EXIT_DONE && command.output == NULL)
        printf("%s\n", drawing.output);
    return status;
}
#endif
