// figures.c - the data of the figures of chapter 06.
#include "chapters/06-ray-casting/figures/figures.h"

#include "chapters/06-ray-casting/cast_spheres.h"
#include "chapters/06-ray-casting/explain.h"
#include "exercises/03-screen.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"

#include <stdio.h>
#include <string.h>

// ---- one pixel, explained -----------------------------------------------------------------------

enum { MOST_DRAWN = 4 };

// The numbers of one sphere, as NAME_k.
static void one_sphere(Plot *plot, const Shown *shown, int k, int sphere)
{
    Sphere s = shown->shot.scene->spheres[sphere];
    Quadratic q = object_quadratic(to_object_coordinates(shown->ray, s), s.radius);
    Roots roots = sphere_roots(shown->ray, s);
    const struct {
        const char *name;
        double value;
    } numbers[] = {{"a", q.a},
                   {"b", q.b},
                   {"c", q.c},
                   {"discriminant", discriminant(q)},
                   {"roots", roots.count},
                   {"root_0", roots.count > 0 ? roots.t[0] : 0},
                   {"root_1", roots.count > 0 ? roots.t[1] : 0}};
    for (int i = 0; i < 7; i++)
        plot_number(plot, text_of("%s_%d", numbers[i].name, k).s, numbers[i].value);
    plot_text(plot, text_of("name_%d", k).s, sphere_name(sphere).s);
}

static void the_color(Plot *plot, const Shown *shown)
{
    const Scene *scene = shown->shot.scene;
    bool any = shown->hit_count > 0;
    Color color = any ? scene_surface(scene, shown->hits[0].sphere)->color : scene->background;
    plot_text(plot, "bytes_text",
              text_of("%d, %d, %d", byte_from_color(color[0]), byte_from_color(color[1]),
                      byte_from_color(color[2]))
                  .s);
    plot_direction(plot, "color", color);
}

// What becomes of one of the spheres.
static Text say_sphere(const Shown *shown, int k, int sphere)
{
    Sphere s = shown->shot.scene->spheres[sphere];
    Text name = sphere_name(sphere);
    if (hit_sphere(shown->ray, s) < NO_HIT)
        return text_of("%s: $t$ = {root_0_%d}, {root_1_%d}", name.s, k, k);
    return text_of("%s: %s", name.s,
                   sphere_roots(shown->ray, s).count > 0 ? "behind the eye" : "missed");
}

// The story in three blocks of words below the picture: the ray, its hits, the color.
static void say(Plot *plot, const Shown *shown, const Outcome *outcome)
{
    Label hits[MOST_DRAWN];
    Text texts[MOST_DRAWN];
    for (int i = 0; i < outcome->told_count; i++) {
        texts[i] = say_sphere(shown, i + 1, outcome->told[i]);
        hits[i] = (Label){texts[i].s, "ink", .step = 4};
    }
    Text nearest = {"no hit: background"};
    if (shown->hit_count > 0)
        nearest = text_of("smallest $t$: {nearest}, %s", sphere_name(shown->hits[0].sphere).s);
    plot_say(plot, 0, 0, {"pixel {pixel} of {size}", "ink", .step = 1},
             {"$s$ = {s}, $t$ = {t}", "ink", .step = 1}, {"$v$ = {vector_v}", "blue", .step = 2});
    plot_say(plot, 1, 0, {nearest.s, "blue", .step = 5}, {"color {bytes}", "ink", .step = 6});
    plot_say_of(plot, 0.52, 0, outcome->told_count, hits);
}

void explain_figure_data(Plot *plot, void *given)
{
    const Shown *shown = given;
    Shot shot = shown->shot;
    ScreenPoint point = pixel_center(shot.pixel);
    Normalized place = screen_to_normalized(point, shot.size);
    shown_data(plot, shown);
    shown_patches(plot, shown);
    plot_include(plot, "common/figure/spheres.gp");
    plot_number(plot, "screen_x", point.x);
    plot_number(plot, "screen_y", point.y);
    plot_number(plot, "s", place.s);
    plot_number(plot, "t", place.t);
    plot_vector(plot, "vector_v", shot.camera.origin,
                ray_to_plane(shown->ray, shot.camera).direction);
    // It ends on the plane that is drawn, which may be nearer to the eye than the end of the
    // vector.
    plot_vector(plot, "arrow", shot.camera.origin,
                ray_to_plane(shown->ray, shown->camera).direction);
    plot_direction(plot, "p", shown->ray.origin);
    plot_direction(plot, "v", shown->ray.direction);
    Outcome outcome = outcome_of(shown->ray, shot.scene, MOST_DRAWN);
    plot_number(plot, "told", outcome.told_count);
    for (int i = 0; i < outcome.told_count; i++)
        one_sphere(plot, shown, i + 1, outcome.told[i]);
    the_color(plot, shown);
    shown_look(plot, shown);
    plot_room(plot, (Room){0.03, 0.97, 0.27, 0.86}, (Room){0.03, 0.97, 0.45, 0.86});
    say(plot, shown, &outcome);
}

// ---- the figures --------------------------------------------------------------------------------

#define FOLDER "chapters/06-ray-casting"

// ---- image order, and the whole of ray casting ------------------------------------------------

// The drawn pixels in the colors of the spheres that they show in a scene. Its sphere 0 is sphere
// 'first' of the whole scene. A pixel that shows no sphere keeps the background. Returns how many
// show one.
static int cells_data(Plot *plot, const Shown *shown, const Scene *scene, int first)
{
    int spheres[MOST_CELLS * MOST_CELLS], cells = 0, count = shown->grid.width * shown->grid.height;
    if (!cast_spheres(scene, shown->shot.camera, shown->grid, spheres))
        count = 0;
    for (int i = 0; i < count; i++)
        if (is_sphere(scene, spheres[i])) {
            Pixel cell = {i % shown->grid.width, i / shown->grid.width};
            Color color = scene_surface(shown->shot.scene, first + spheres[i])->color;
            shown_cell(plot, shown, cell, color);
            cells++;
        }
    shown_cells_end(plot, shown, cells);
    return cells;
}

static int cast_cells(Plot *plot, const Shown *shown)
{
    shown_cells_begin(plot, "pixels");
    return cells_data(plot, shown, shown->shot.scene, 0);
}

static int ray_casting_data(Plot *plot, const Shown *shown)
{
    shown_data(plot, shown);
    shown_patches(plot, shown);
    plot_include(plot, "common/figure/spheres.gp");
    shown_look(plot, shown);
    return cast_cells(plot, shown);
}

static void counted(Plot *plot, int step, int cells, const char *what)
{
    plot_say(plot, 0.5, 0,
             {text_of("%d pixel center%s%s", cells, cells == 1 ? "" : "s", what).s, "ink",
              .step = step});
}

// What the ray meets, at the places where it does.
static void hit_names(Plot *plot, const Shown *shown)
{
    if (shown->hit_count == 0)
        plot_say(
            plot, 0.5, 0,
            {plot_says_yours(plot, "all_hits") ? "your ray meets nothing" : "the ray meets nothing",
             "ink", .step = 3});
    for (int i = 0; i < shown->hit_count && i < MOST_HITS; i++) {
        Text text = text_of("$t$ = %s, sphere %s%s", number_shown(shown->hits[i].t).s,
                            sphere_name(shown->hits[i].sphere).s, i == 0 ? ": closest" : "");
        plot_name(plot, (Label){text.s, "ink", .step = 3, .block = "hits", .row = i});
    }
}

// The picture at the upper left (common/figure/spheres.gp).
static void picture_is_clear(Plot *plot)
{
    plot_keep_clear(plot, (Room){0.02, 0.19, 0.51, 0.86}, (Room){0.03, 0.25, 0.51, 0.86});
}

// In words, the hits after the closest one.
static void farther_hits(Plot *plot, const Shown *shown)
{
    char text[1000] = "";
    for (int i = 1; i < shown->hit_count && i < MOST_HITS; i++)
        snprintf(text + strlen(text), sizeof text - strlen(text), "It meets sphere %s at t = %s. ",
                 sphere_name(shown->hits[i].sphere).s, number_shown(shown->hits[i].t).s);
    plot_text(plot, "farther_hits", text);
}

static void ray_casting(Plot *plot, void *given)
{
    ray_casting_data(plot, given);
    farther_hits(plot, given);
    hit_names(plot, given);
    picture_is_clear(plot);
}

// The ray of a pixel that hits nothing; of several, the one nearest to a place up and to the left.
// Without one, a ray of no length.
static Ray missing_ray(const Shown *shown)
{
    double best = INFINITY;
    Ray ray = {shown->ray.origin, vec3_of(0, 0, 0)};
    for (int i = 0; i < shown->grid.width * shown->grid.height; i++) {
        Pixel cell = {i % shown->grid.width, i / shown->grid.width};
        Ray r = ray_to_plane(pixel_ray(shown->shot.camera, shown->grid, cell), shown->shot.camera);
        double x = (cell.column + 0.5) / shown->grid.width - 0.2;
        double y = (cell.row + 0.5) / shown->grid.height - 0.2;
        if (nearest_hit(r, shown->shot.scene).sphere < 0 && x * x + y * y < best) {
            best = x * x + y * y;
            ray = r;
        }
    }
    return ray;
}

// How far to draw that ray: as far as the pixel's, but not far away at the edge of a wide angle.
static double missing_end(const Shown *shown, Ray miss)
{
    double longer = vec3_length(miss.direction) / (2 * vec3_length(shown->ray.direction));
    return shown_end(shown) / fmax(1, longer);
}

// Object order and image order show the same: one after the other on a slide, nothing jumps.
static void same_view(Plot *plot, const Shown *shown, Ray miss)
{
    const Room room = {0.04, 0.96, 0.14, 0.84};
    plot_fit(plot, shown->ray.origin + shown_end(shown) * shown->ray.direction, 0);
    plot_fit(plot, shown->ray.origin + missing_end(shown, miss) * miss.direction, 0);
    plot_room(plot, room, room);
    plot_fill_room(plot);
    picture_is_clear(plot);
}

static void image_order(Plot *plot, void *given)
{
    const Shown *shown = given;
    int cells = ray_casting_data(plot, shown);
    Ray miss = missing_ray(shown);
    plot_number(plot, "misses", vec3_length(miss.direction) > 0);
    shown_ray(plot, "miss", miss, missing_end(shown, miss), missing_end(shown, miss));
    counted(plot, 5, cells, " hit");
    same_view(plot, shown, miss);
}

// ---- object order -----------------------------------------------------------------------------

// The sphere that the pixel's ray hits. If there is none, the one that most pixels show.
static int the_object(const Shown *shown)
{
    const Scene *scene = shown->shot.scene;
    if (shown->hit_count > 0)
        return shown->hits[0].sphere;
    return shown->sphere_count > 0 ? shown->spheres[0] : scene->sphere_count > 0 ? 0 : -1;
}

// The pixels that one sphere would color if it were alone.
static int cells_of(Plot *plot, const Shown *shown, int object)
{
    Scene alone = *shown->shot.scene;
    alone.spheres += object < 0 ? 0 : object;
    alone.sphere_count = object < 0 ? 0 : 1;
    shown_cells_begin(plot, "pixels");
    return cells_data(plot, shown, &alone, object < 0 ? 0 : object);
}

static void object_order(Plot *plot, void *given)
{
    Shown *shown = given;
    int object = the_object(shown);
    if (object >= 0)
        shown_only(shown, object);
    shown_data(plot, shown);
    plot_include(plot, "common/figure/spheres.gp");
    int cells = cells_of(plot, shown, object);
    Text name = object < 0 ? (Text){""} : sphere_name(object);
    plot_text(plot, "object_name", name.s);
    // Without a sphere there is no outline: a point takes its place.
    Sphere sphere = {.center = shown->shot.camera.origin + shown->shot.camera.forward};
    if (object >= 0)
        sphere = shown->shot.scene->spheres[object];
    bool inside = vec3_length(sphere.center - shown->camera.origin) < sphere.radius;
    plot_number(plot, "eye_inside", inside);
    outline_on_plane(plot, "outline", shown->camera, sphere);
    lines_to_eye(plot, "lines", "heads", shown->camera, sphere, shown->sphere_count > 0);
    shown_look(plot, shown);
    counted(plot, 4, cells,
            text_of(inside ? ", because the eye is in %s" : " inside the outline of %s", name.s).s);
    same_view(plot, shown, missing_ray(shown));
}

// ---- all --------------------------------------------------------------------------------------

static const Figure figures[] = {
    {"object-order", object_order},   {"image-order", image_order},
    {"ray-casting", ray_casting},     {"nearest-hit", nearest_figure_data},
    {"explain", explain_figure_data}, {0}};

// The scenes of the figures, and pixels whose hits are visible from the figure's viewpoint.
static const struct {
    const char *name, *scene;
    Pixel pixel;
} own[] = {
    {"object-order", FOLDER "/figures/one-sphere.nff", {5, 2}},
    {"image-order", FOLDER "/figures/one-sphere.nff", {5, 2}},
    {"ray-casting", FOLDER "/figures/four-spheres.nff", {4, 4}},
    {"nearest-hit", FOLDER "/figures/along-a-ray.nff", {0, 0}},
    {"explain", FOLDER "/figures/four-spheres.nff", {4, 4}},
    {NULL, FOLDER "/three-spheres.nff", {300, 200}},
};

static int own_of(const char *name)
{
    int i = 0;
    while (own[i].name != NULL && strcmp(own[i].name, name) != 0)
        i++;
    return i;
}

const char *figure_scene(const char *name)
{
    return own[own_of(name)].scene;
}

Pixel figure_pixel(const char *name)
{
    return own[own_of(name)].pixel;
}

int casting_figure(const char *program, FigureCommand command, Shot shot)
{
    Shown shown;
    shown_choose(&shown, shot);
    return plot_figure(program, FOLDER, figures, command, &shown);
}
