// main.c - chapter 07: light, and the color that a surface sends back.
//
// Draws a scene with light. Without arguments it draws the deck's closing slide again: three
// spheres, flat and shaded, side by side.
#include "chapters/07-shading/explain_light.h"
#include "chapters/07-shading/export.h"
#include "chapters/07-shading/figures/figures.h"
#include "chapters/shared/lighting.h"
#include "chapters/shared/needed_answers.h"
#include "chapters/shared/render.h"
#include "chapters/shared/scene_command.h"
#include "common/picture.h"
#include "common/story.h"
#include "common/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---- the program --------------------------------------------------------------------------------

// An option that was not given: the closing slide has another style than other pictures.
enum { UNTOLD = -1 };

static void set_untold(Style *told, Style style)
{
    if (told->samples == UNTOLD)
        told->samples = style.samples;
    if (told->depth == UNTOLD)
        told->depth = style.depth;
}

// The pixel that is explained by default: near the highlight of the red sphere.
static const Pixel in_the_light = {370, 110};

static const struct {
    const char *word;
    Term term;
} terms[] = {{"ambient", TERM_AMBIENT}, {"diffuse", TERM_DIFFUSE}, {"specular", TERM_SPECULAR}};

static bool option_term(const char *text, void *into)
{
    for (size_t i = 0; i < sizeof terms / sizeof terms[0]; i++)
        if (strcmp(text, terms[i].word) == 0) {
            *(Term *)into = terms[i].term;
            return true;
        }
    return false;
}

static bool option_format(const char *text, void *into)
{
    *(ExportFormat *)into = strcmp(text, "pov") == 0 ? EXPORT_POV : EXPORT_PBRT;
    return strcmp(text, "pov") == 0 || strcmp(text, "pbrt") == 0;
}

// Flat at the left, shaded at the right. False if there is not enough memory.
static bool draw_both(Drawing *drawing, Style style)
{
    Image left = drawing->image, right = {0}, both = {0};
    Resolution size = left.size, wide = {2 * size.width, size.height};
    Message message;
    if (!image_create(&right, size, &message) || !image_create(&both, wide, &message)) {
        fprintf(stderr, "%s: %s\n", drawing->program, message.text);
        image_free(&right);
        return false;
    }
    right.progress = left.progress;
    render(&drawing->scene, drawing->camera, style, &right);
    keep_term(&drawing->scene, TERM_FLAT);
    render(&drawing->scene, drawing->camera, style, &left);
    size_t line = 3 * (size_t)size.width;
    for (size_t row = 0; row < (size_t)size.height; row++) {
        memcpy(both.rgb + 2 * row * line, left.rgb + row * line, line);
        memcpy(both.rgb + (2 * row + 1) * line, right.rgb + row * line, line);
    }
    image_free(&left);
    image_free(&right);
    drawing->image = both;
    return true;
}

static int write_export(const Drawing *drawing, ExportFormat format, Style style, bool flat)
{
    const char *slash = strrchr(drawing->scene_path, '/');
    Export what = {format,
                   &drawing->scene,
                   drawing->camera,
                   drawing->image.size,
                   style.depth,
                   flat,
                   word_text(slash != NULL ? slash + 1 : drawing->scene_path)};
    Message message;
    if (export_scene(&what, drawing->output, &message))
        return EXIT_DONE;
    fprintf(stderr, "%s: %s\n", drawing->program, message.text);
    return EXIT_COULD_NOT;
}

int main(int argc, char **argv)
{
    Command command = {0};
    Lighting lighting = lighting_untold;
    lighting.style.samples = lighting.style.depth = UNTOLD;
    Term term = TERM_ALL;
    ExportFormat format = EXPORT_NONE;
    bool flat = false;
    Pixel pixel = {-1, -1};
    FigureCommand figure = {0};
    Plane plane = {vec3_of(NAN, NAN, NAN), vec3_of(NAN, NAN, NAN)};
    const Option options[] = {
        COMMAND_OPTIONS(command),
        {"explain", 0, "COLUMN,ROW", option_pixel, &pixel,
         "explain the light at a pixel, in numbers"},
        {"flat", 0, NULL, option_flag, &flat, "draw without shading"},
        {"term", 0, "NAME", option_term, &term, "only ambient, diffuse or specular light"},
        LIGHTING_OPTIONS(lighting),
        {"export", 0, "pov|pbrt", option_format, &format,
         "write the scene for that renderer, to -o"},
        FIGURE_OPTIONS(figure),
        PLANE_OPTIONS(plane),
        {0}};
    Usage usage = {"[OPTION]... [SCENE.nff]",
                   "Draws a scene with light. Without a scene: the deck's three spheres, flat and\n"
                   "shaded, side by side."};
    int first = options_read(argc, argv, options, usage);
    if (argc - first > 1)
        options_wrong(argv[0], "%d scenes, expected one", argc - first);
    if (format != EXPORT_NONE && command.output == NULL)
        options_wrong(argv[0], "--export: expected -o FILE as well");
    command.scene_path = argv[first];
    bool closing = argv[first] == NULL && !flat && term == TERM_ALL && format == EXPORT_NONE;
    if (closing)
        command.picture_name = "still-something-missing";
    Style closing_told = lighting.style; // the numbers of a pixel are with mirrors
    set_untold(&closing_told, closing_style);
    set_untold(&lighting.style, lighting_untold.style);
    lighting_check(&lighting, argv[0]);

    static Drawing drawing;
    // Another renderer shades an exported scene.
    bool ready = format != EXPORT_NONE ? picture_needs_are_met(IMAGE_ORDER)
                                       : shading_needs_are_met(lighting.style);
    if (!ready ||
        !drawing_begin(&drawing, argv[0], &command, "chapters/06-ray-casting/three-spheres.nff"))
        return EXIT_COULD_NOT;
    Scene *scene = &drawing.scene;
    if (!lighting_apply(&lighting, scene)) {
        fprintf(stderr, "%s: no memory for a light\n", argv[0]);
        return EXIT_COULD_NOT;
    }
    if (figure.name != NULL)
        return plot_figure(argv[0], "chapters/07-shading", shading_figures, figure,
                           &(Given){drawing, plane});
    if (format != EXPORT_NONE)
        return write_export(&drawing, format, lighting.style, flat);
    if (pixel.column >= drawing.image.size.width || pixel.row >= drawing.image.size.height)
        options_wrong(argv[0], "--explain: (%d, %d) is not in a picture of %d x %d", pixel.column,
                      pixel.row, drawing.image.size.width, drawing.image.size.height);
    if (argc == 1 || pixel.column >= 0)
        explain_light(scene, drawing.camera, drawing.image.size, argc == 1 ? in_the_light : pixel,
                      lighting.style.depth, NULL);
    if (pixel.column >= 0)
        return story_end();
    keep_term(scene, flat ? TERM_FLAT : term);
    if (!closing)
        render(scene, drawing.camera, lighting.style, &drawing.image);
    else if (!draw_both(&drawing, closing_told))
        return EXIT_COULD_NOT;
    int status = drawing_end(&drawing);
    if (status == EXIT_DONE && command.output == NULL)
        printf("%s%s\n", argc == 1 ? "\nThe picture: " : "", drawing.output);
    return status;
}
