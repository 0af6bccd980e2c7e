// main.c - chapter 07: light, and the colour that a surface sends back.
//
// Draws a scene with light. Without arguments it draws the deck's closing slide again: three
// spheres, flat and shaded, side by side.
#include "chapters/07-shading/export.h"
#include "chapters/07-shading/figures/figures.h"
#include "chapters/shared/lighting.h"
#include "chapters/shared/needed_answers.h"
#include "chapters/shared/render.h"
#include "chapters/shared/scene_command.h"
#include "common/picture.h"
#include "common/story.h"
#include "common/text.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---- the light at one point, in numbers ---------------------------------------------------------

// The colour that shade returns for one light alone, and a surface with only one of the two terms.
static vec3 one_term(const Scene *scene, Light light, Ray ray, Hit hit, bool diffuse)
{
    Surface surface = *scene_surface(scene, hit.sphere);
    Scene alone = *scene;
    *(diffuse ? &surface.specular : &surface.diffuse) = 0;
    alone.ambient = vec3_of(0, 0, 0);
    alone.lights = &light;
    alone.light_count = 1;
    alone.surfaces = &surface;
    alone.surface_count = 1;
    Sphere *spheres = malloc((size_t)scene->sphere_count * sizeof *spheres);
    if (spheres == NULL)
        return vec3_of(NAN, NAN, NAN);
    memcpy(spheres, scene->spheres, (size_t)scene->sphere_count * sizeof *spheres);
    for (int i = 0; i < scene->sphere_count; i++)
        spheres[i].surface = 0;
    alone.spheres = spheres;
    vec3 color = shade(&alone, ray, hit);
    free(spheres);
    return color;
}

static void tell_surface(const Scene *scene, int sphere)
{
    const Surface *surface = scene_surface(scene, sphere);
    story_line("colour, Kd, Ks, Shine", "%s, %s, %s, %s", vec3_text(surface->color).s,
               number_text(surface->diffuse).s, number_text(surface->specular).s,
               number_text(surface->shine).s);
    story_line("ambient", "%s",
               vec3_text(ambient_term(surface->color, surface->diffuse, scene->ambient)).s);
}

static void tell_light(const Scene *scene, int i, Ray ray, Hit hit, vec3 normal, vec3 start)
{
    Light light = scene->lights[i];
    const Surface *surface = scene_surface(scene, hit.sphere);
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 to_light = ray_to_light(point, light).direction;
    bool arrives = visibility(scene, start, light) > 0;
    story_heading("Light %d, %s", i + 1, vec3_text(light.color).s);
    story_line("from the point to it", "%s, unit %s", vec3_text(to_light).s,
               vec3_text_to(vec3_unit(to_light), 4).s);
    story_line("arrives", "%s", arrives ? "yes" : "no: something is in between");
    story_line("cosine with the normal", "%s",
               number_text(vec3_dot(normal, vec3_unit(to_light))).s);
    story_line("diffuse", "%s", vec3_text_to(one_term(scene, light, ray, hit, true), 4).s);
    story_line("specular, Phong", "%s", vec3_text_to(one_term(scene, light, ray, hit, false), 4).s);
    story_line("specular, Blinn", "%s",
               vec3_text_to(halfway_term(surface->specular, surface->shine,
                                         arrives ? light.color : vec3_of(0, 0, 0), normal, to_light,
                                         -ray.direction),
                            4)
                   .s);
}

// Prints the light that the ray of a pixel sees, term by term, with depth mirrors.
static void tell_shading(const Drawing *drawing, Pixel pixel, int depth)
{
    const Scene *scene = &drawing->scene;
    Resolution screen = drawing->image.size;
    Ray ray = pixel_ray(drawing->camera, screen, pixel);
    Hit hit = nearest_hit(ray, scene);
    printf("07-shading: light, and the colour that a surface sends back\n");
    story_heading("What pixel (%d, %d) sees", pixel.column, pixel.row);
    if (hit.sphere < 0) {
        story_line("nothing", "the background, %s", vec3_text(scene->background).s);
        return;
    }
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = surface_normal(sphere, point);
    vec3 start = offset_from_surface(sphere, point, normal);
    story_line("sphere", "%c, t = %s", 'A' + hit.sphere % 26, number_text(hit.t).s);
    story_line("point", "%s", vec3_text(point).s);
    story_line("normal", "%s", vec3_text(normal).s);
    story_line("shadow bias", "%s", number_text(vec3_length(start - point)).s);
    tell_surface(scene, hit.sphere);
    for (int i = 0; i < scene->light_count; i++)
        tell_light(scene, i, ray, hit, normal, start);
    story_heading("Together");
    story_line("shade", "%s", vec3_text_to(shade(scene, ray, hit), 4).s);
    story_line("with mirrors", "%s", vec3_text_to(trace_ray(scene, ray, depth), 4).s);
    story_line("clamped", "%s", vec3_text_to(clamp_color(trace_ray(scene, ray, depth)), 4).s);
}

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
        return shading_figure(figure, &drawing, plane);
    if (format != EXPORT_NONE)
        return write_export(&drawing, format, lighting.style, flat);
    if (pixel.column >= drawing.image.size.width || pixel.row >= drawing.image.size.height)
        options_wrong(argv[0], "--explain: (%d, %d) is not in a picture of %d x %d", pixel.column,
                      pixel.row, drawing.image.size.width, drawing.image.size.height);
    if (argc == 1 || pixel.column >= 0)
        tell_shading(&drawing, argc == 1 ? in_the_light : pixel, lighting.style.depth);
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
