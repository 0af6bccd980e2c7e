// main.c - chapter 07: light, and what a surface makes of it.
//
// Draws a scene shaded. Without arguments it makes the deck's closing slide again: three spheres,
// flat and shaded, side by side.
#include "chapters/06-ray-casting/command.h"
#include "chapters/07-shading/export.h"
#include "chapters/07-shading/figures.h"
#include "chapters/07-shading/render.h"
#include "chapters/07-shading/story.h"
#include "common/picture.h"
#include "common/story.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Where the story is told unless told: near the highlight of the red sphere.
static const Pixel in_the_light = {430, 130};

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

static bool option_count(const char *text, void *into)
{
    char *end;
    long count = strtol(text, &end, 10);
    if (end == text || *end != '\0' || count < 0 || count > 64)
        return false;
    *(int *)into = (int)count;
    return true;
}

// Flat at the left, shaded at the right. False where memory is short.
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
    Style style = {.samples = 1, .depth = 5, .gamma = 1};
    Term term = TERM_ALL;
    ExportFormat format = EXPORT_NONE;
    bool flat = false;
    double ambient = -1;
    Pixel pixel = {-1, -1};
    FigureCommand figure = {0};
    vec3 sun = vec3_of(0, 0, 0);
    const Option options[] = {
        COMMAND_OPTIONS(command),
        {"explain", 0, "COLUMN,ROW", option_pixel, &pixel, "the light at a pixel, in numbers"},
        {"flat", 0, NULL, option_flag, &flat, "leave the shading out"},
        {"term", 0, "NAME", option_term, &term, "only ambient, diffuse or specular light"},
        {"depth", 0, "N", option_count, &style.depth, "mirrors to follow a ray through (5)"},
        {"samples", 0, "N", option_count, &style.samples, "N x N samples a pixel (1)"},
        {"ambient", 0, "A", option_number, &ambient, "light that is everywhere (0.1)"},
        {"sun", 0, "X,Y,Z", option_vec3, &sun, "a distant light from there, no others"},
        {"gamma", 0, "G", option_number, &style.gamma, "of the display (1: leave as is)"},
        {"export", 0, "pov|pbrt", option_format, &format,
         "write the scene for them instead (to -o)"},
        FIGURE_OPTIONS(figure),
        {0}};
    Usage usage = {"[OPTION]... [SCENE.nff]",
                   "Casts a scene, shaded. Without a scene: the deck's three spheres, flat and\n"
                   "shaded, side by side."};
    int first = options_read(argc, argv, options, usage);
    if (argc - first > 1)
        options_wrong(argv[0], "%d scenes, expected one", argc - first);
    if (style.samples < 1)
        options_wrong(argv[0], "--samples: expected 1 to 64");
    if (!(style.gamma > 0))
        options_wrong(argv[0], "--gamma: expected more than 0");
    if (format != EXPORT_NONE && command.output == NULL)
        options_wrong(argv[0], "--export: expected -o FILE as well");
    command.scene_path = argv[first];
    bool closing = argv[first] == NULL && !flat && term == TERM_ALL && format == EXPORT_NONE;
    if (closing)
        command.picture_name = "still-something-missing";

    static Drawing drawing;
    if (!shading_needs_are_met() ||
        !drawing_begin(&drawing, argv[0], &command, "chapters/06-ray-casting/three-spheres.nff"))
        return EXIT_COULD_NOT;
    Scene *scene = &drawing.scene;
    if (ambient >= 0)
        scene->ambient = vec3_of(ambient, ambient, ambient);
    Light distant = {sun, vec3_of(1, 1, 1), LIGHT_DISTANT};
    Light *own = scene->lights;
    if (vec3_dot(sun, sun) > 0) {
        scene->lights = &distant;
        scene->light_count = 1;
    }
    if (figure.name != NULL)
        return shading_figure(figure, &drawing);
    if (format != EXPORT_NONE)
        return write_export(&drawing, format, style, flat);
    if (pixel.column >= drawing.image.size.width || pixel.row >= drawing.image.size.height)
        options_wrong(argv[0], "--explain: (%d, %d) is not in a picture of %d x %d", pixel.column,
                      pixel.row, drawing.image.size.width, drawing.image.size.height);
    if (argc == 1 || pixel.column >= 0)
        tell_shading(&drawing, argc == 1 ? in_the_light : pixel, style.depth);
    if (pixel.column >= 0)
        return story_end();
    keep_term(scene, flat ? TERM_FLAT : term);
    if (!closing)
        render(scene, drawing.camera, style, &drawing.image);
    else if (!draw_both(&drawing, style))
        return EXIT_COULD_NOT;
    scene->lights = own;
    int status = drawing_end(&drawing);
    if (status == EXIT_DONE && command.output == NULL)
        printf("%s%s\n", argc == 1 ? "\nThe picture: " : "", drawing.output);
    return status;
}
