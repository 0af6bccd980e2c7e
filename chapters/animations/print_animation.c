// print_animation.c - prints the script of an animation: the data of all its moments, by the linked
// answers, and its layout, chapters/animations/NAME.gp.
//
//   print_animation NAME [SCENE.nff]
//
// Without a scene, the scenes of the figures. From the top of the project.
#include "chapters/05-quadratic/figures/figures.h"
#include "chapters/06-ray-casting/figures/figures.h"
#include "chapters/animations/moments.h"
#include "chapters/shared/example.h"
#include "chapters/shared/needed_answers.h"
#include "chapters/shared/scene_command.h"
#include "common/answers.h"
#include "common/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// figure: the one of chapter 06 whose scene and pixel are shown; NULL: the sphere of the example.
static const struct {
    Figure animation;
    const char *figure;
} animations[] = {{{"image-order", image_order_moments}, "ray-casting"},
                  {{"object-order", object_order_moments}, "ray-casting"},
                  {{"closest-hit", closest_hit_moments}, "nearest-hit"},
                  {{"discriminant", discriminant_moments}, NULL},
                  {{NULL, NULL}, NULL}};

// An animation, and what it shows.
typedef struct {
    const Figure *animation;
    void *given;
} Moving;

static void data(Plot *plot, void *given)
{
    const Moving *moving = given;
    plot_include(plot, "chapters/animations/frame.gp");
    moving->animation->data(plot, moving->given);
}

static int print(const Figure *animation, void *given)
{
    char layout[200], *script = NULL;
    size_t size;
    snprintf(layout, sizeof layout, "chapters/animations/%s.gp", animation->name);
    FILE *out = open_memstream(&script, &size);
    if (out == NULL)
        return EXIT_COULD_NOT;
    bool written = plot_script(out, layout, &(Figure){animation->name, data}, NULL, NULL,
                               &(Moving){animation, given});
    fclose(out);
    int status = written ? answers_report() : EXIT_COULD_NOT;
    if (status == EXIT_DONE)
        fputs(script, stdout);
    free(script);
    return status;
}

// Of a scene that is not the figure's own, the pixel whose ray meets most.
static int print_of_scene(const char *program, int i, const char *scene)
{
    static Drawing drawing;
    static Shown shown;
    Command command = {.scene_path = scene != NULL ? scene : figure_scene(animations[i].figure)};
    if (!picture_needs_are_met(IMAGE_ORDER) || !picture_needs_are_met(OBJECT_ORDER) ||
        !drawing_prepare(&drawing, program, &command, NULL))
        return EXIT_COULD_NOT;
    Pixel pixel = scene != NULL ? (Pixel){-1, -1} : figure_pixel(animations[i].figure);
    shown_choose(&shown, (Shot){&drawing.scene, drawing.camera, drawing.size, pixel});
    int status = print(&animations[i].animation, &shown);
    scene_free(&drawing.scene);
    return status;
}

int main(int argc, char **argv)
{
    int i = 0;
    while (argc > 1 && animations[i].animation.name != NULL &&
           strcmp(argv[1], animations[i].animation.name) != 0)
        i++;
    if (argc < 2 || argc > 3 || animations[i].animation.name == NULL) {
        fprintf(stderr, "Usage: %s NAME [SCENE.nff], where NAME is one of", argv[0]);
        for (i = 0; animations[i].animation.name != NULL; i++)
            fprintf(stderr, " %s", animations[i].animation.name);
        fprintf(stderr, "\n");
        return EXIT_WRONG_USAGE;
    }
    if (animations[i].figure != NULL)
        return print_of_scene(argv[0], i, argv[2]);
    Meeting meeting = {example_ray(), example_sphere()};
    return print(&animations[i].animation, &meeting);
}
