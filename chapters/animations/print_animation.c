// print_animation.c - prints the script of an animation: the data of all its moments, by the linked
// answers, and its layout, chapters/animations/NAME.gp.
//
//   print_animation NAME [SCENE.nff]
//
// Without a scene, the scenes of the figures. From the top of the project.
//
// A moment is a step of the layout (common/figure/plot.gp): one script has the data of all of them.
// given is a Shown: the scene, the camera and one pixel.
#include "chapters/05-quadratic/figures/figures.h"
#include "chapters/06-ray-casting/cast_spheres.h"
#include "chapters/06-ray-casting/figures/figures.h"
#include "chapters/shared/example.h"
#include "chapters/shared/needed_answers.h"
#include "chapters/shared/scene_command.h"
#include "common/answers.h"
#include "common/figure/plot.h"
#include "common/text.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    MOST_SETS = 4 * MOST_CELLS * MOST_CELLS, // an answer may set a pixel several times
    RAY_PLACES = 80,
    GROWING = 8, // moments in which the lines of a sphere grow
    OUTLINED = 6,
    TESTING = 14, // moments in which the ray looks for its hit with one sphere
    TESTED = 8,
    MOST_ASKED = 8 // spheres, also those that are missed
};

// ---- pixels in the order in which they are set ------------------------------------------------

typedef struct {
    PixelSet sets[MOST_SETS];
    int count;
} Sets;

static Color color_of(const Shown *shown, int sphere)
{
    const Scene *scene = shown->shot.scene;
    return is_sphere(scene, sphere) ? scene_surface(scene, sphere)->color : scene->background;
}

// $sets, a pixel after the other; and of each its column, its row, its sphere.
static void sets_data(Plot *plot, const Shown *shown, const Sets *sets)
{
    plot_number(plot, "columns", shown->grid.width);
    plot_number(plot, "rows", shown->grid.height);
    plot_number(plot, "sets", sets->count);
    shown_cells_begin(plot, "sets");
    for (int i = 0; i < sets->count; i++)
        shown_cell(plot, shown, sets->sets[i].pixel, color_of(shown, sets->sets[i].sphere));
    shown_cells_end(plot, shown, sets->count);
    plot_block(plot, "pixel_sets", "column row sphere");
    for (int i = 0; i < sets->count; i++)
        plot_row(plot, sets->sets[i].pixel.column, sets->sets[i].pixel.row, sets->sets[i].sphere);
}

// The scene, and its pixels as an answer sets them.
static void order_data(Plot *plot, const Shown *shown, Order order, Sets *sets)
{
    int count = cast_pixel_sets(shown->shot.scene, shown->shot.camera, shown->grid, order,
                                sets->sets, MOST_SETS);
    sets->count = count < 0 ? 0 : count < MOST_SETS ? count : MOST_SETS;
    shown_data(plot, shown);
    plot_include(plot, "common/figure/spheres.gp");
    sets_data(plot, shown, sets);
}

// The ray of each pixel that is set, up to its hit; one that hits nothing, as far as any is drawn.
static void rays_data(Plot *plot, const Shown *shown, const Sets *sets)
{
    double farthest = shown_end(shown);
    plot_block(plot, "rays", "x y z t, 1 for the drawn part");
    for (int i = 0; i < sets->count; i++) {
        Ray ray = ray_to_plane(pixel_ray(shown->shot.camera, shown->grid, sets->sets[i].pixel),
                               shown->shot.camera);
        Hit hit = nearest_hit(ray, shown->shot.scene);
        double end = hit.sphere < 0 ? farthest : hit.t;
        for (int k = 0; k <= RAY_PLACES; k++) {
            vec3 p = ray.origin + end * k / RAY_PLACES * ray.direction;
            plot_row_at(plot, p, end * k / RAY_PLACES, 1);
        }
        plot_gap(plot);
    }
}

// The pixels of the picture, as the answer to cast_image_order sets them, each with its ray.
static void image_order_moments(Plot *plot, void *given)
{
    static Sets sets;
    order_data(plot, given, IMAGE_ORDER, &sets);
    rays_data(plot, given, &sets);
}

// ---- spheres in the order in which they are taken ---------------------------------------------

// A moment: the sphere (-1: none yet), how much of its lines is drawn, whether its outline is, and
// how many pixels have been set.
static void moment(Plot *plot, int sphere, double lines, bool outline, int sets)
{
    plot_row(plot, sphere, lines, outline, sets);
}

static void begin_sphere(Plot *plot, int sphere, int sets)
{
    for (int k = 1; k <= GROWING; k++)
        moment(plot, sphere, (double)k / GROWING, false, sets);
    for (int k = 0; k < OUTLINED; k++)
        moment(plot, sphere, 1, true, sets);
}

// The background is set at once; then, for each sphere, its lines, its outline, its pixels.
static void order_of_spheres(Plot *plot, const Shown *shown, const Sets *sets)
{
    int sphere = -1, background = 0;
    while (background < sets->count && sets->sets[background].sphere < 0)
        background++;
    plot_block(plot, "moments", "sphere, part of its lines, 1 with its outline, pixels set");
    moment(plot, -1, 0, false, 0);
    moment(plot, -1, 0, false, background);
    for (int i = background; i < sets->count; i++) {
        int next = sets->sets[i].sphere;
        // A sphere that sets no pixel has its turn before the next one.
        for (int k = next > sphere ? sphere + 1 : next; k <= next && next != sphere; k++)
            begin_sphere(plot, k, i);
        sphere = next;
        moment(plot, sphere, 1, true, i + 1);
    }
    for (int k = sphere + 1; k < shown->shot.scene->sphere_count; k++)
        begin_sphere(plot, k, sets->count);
}

// The pixels of each sphere, and those that it would have if it were alone.
static void pixels_of_spheres(Plot *plot, const Shown *shown, const Sets *sets)
{
    int cells = shown->grid.width * shown->grid.height;
    plot_block(plot, "shares", "sphere, pixels that it sets, pixels inside its outline");
    for (int i = 0; i < shown->shot.scene->sphere_count; i++) {
        int alone[MOST_CELLS * MOST_CELLS], set = 0, inside = 0;
        Scene one = *shown->shot.scene;
        one.spheres += i;
        one.sphere_count = 1;
        bool cast = cast_spheres(&one, shown->shot.camera, shown->grid, alone);
        for (int k = 0; cast && k < cells; k++)
            inside += alone[k] == 0;
        for (int k = 0; k < sets->count; k++)
            set += sets->sets[k].sphere == i;
        plot_row(plot, i, set, inside);
    }
}

// The spheres as the answer to cast_object_order takes them, each with its outline and its pixels.
static void object_order_moments(Plot *plot, void *given)
{
    static Sets sets;
    const Shown *shown = given;
    order_data(plot, shown, OBJECT_ORDER, &sets);
    order_of_spheres(plot, shown, &sets);
    pixels_of_spheres(plot, shown, &sets);
    for (int i = 0; i < shown->shot.scene->sphere_count; i++) {
        Sphere sphere = shown->shot.scene->spheres[i];
        outline_on_plane(plot, text_of("outline%d", i).s, shown->camera, sphere);
        lines_to_eye(plot, text_of("lines%d", i).s, text_of("heads%d", i).s, shown->camera, sphere,
                     true);
    }
}

// ---- one ray, and one sphere after the other --------------------------------------------------

// A moment: the sphere that is asked, up to which t, the closest hit before that, and whether the
// sphere has answered. The closest hit before is that of the same ray and fewer spheres.
static void question(Plot *plot, int sphere, double t, Hit before, bool answered)
{
    plot_row(plot, sphere, t, before.t, before.sphere, answered);
}

// One ray and one sphere after the other: the hit, and the closest hit so far.
static void closest_hit_moments(Plot *plot, void *given)
{
    const Shown *shown = given;
    Scene so_far = *shown->shot.scene;
    nearest_figure_data(plot, given);
    plot_block(plot, "moments",
               "sphere, t of the tip, closest t so far, its sphere, 1 if answered");
    for (int i = 0; i < shown->shot.scene->sphere_count; i++) {
        double t = hit_sphere(shown->ray, shown->shot.scene->spheres[i]);
        double end = t < NO_HIT ? t : shown_end(shown);
        // Among many spheres, those that the ray misses are not worth a moment.
        if (!(t < NO_HIT) && shown->shot.scene->sphere_count > MOST_ASKED)
            continue;
        so_far.sphere_count = i;
        Hit before = nearest_hit(shown->ray, &so_far);
        so_far.sphere_count = i + 1;
        Hit after = nearest_hit(shown->ray, &so_far);
        for (int k = 1; k <= TESTING; k++)
            question(plot, i, end * k / TESTING, before, false);
        for (int k = 0; k < TESTED; k++)
            question(plot, i, end, after, true);
    }
    Hit closest = nearest_hit(shown->ray, shown->shot.scene);
    for (int k = 1; k <= TESTING; k++)
        question(plot, -1, (closest.sphere < 0 ? shown_end(shown) : closest.t) * k / TESTING,
                 closest, k == TESTING);
}

// ---- the program ------------------------------------------------------------------------------

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
    char *script = NULL;
    size_t size;
    Text layout = text_of("chapters/animations/%s.gp", animation->name);
    FILE *out = open_memstream(&script, &size);
    if (out == NULL)
        return EXIT_COULD_NOT;
    bool written = plot_script(out, layout.s, &(Figure){animation->name, data}, NULL, NULL,
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
