// explain_figure.c - one pixel, explained, as the data of a figure.
#include "chapters/06-ray-casting/explain.h"

#include "exercises/03-screen.h"

#include <stdio.h>

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
    char name[40];
    for (int i = 0; i < 7; i++) {
        snprintf(name, sizeof name, "%s_%d", numbers[i].name, k);
        plot_number(plot, name, numbers[i].value);
    }
    snprintf(name, sizeof name, "name_%d", k);
    plot_text(plot, name, sphere_name(sphere).s);
}

static void the_color(Plot *plot, const Shown *shown)
{
    const Scene *scene = shown->shot.scene;
    bool any = shown->hit_count > 0;
    Color color = any ? scene_surface(scene, shown->hits[0].sphere)->color : scene->background;
    char text[60];
    snprintf(text, sizeof text, "%d, %d, %d", byte_from_color(color[0]), byte_from_color(color[1]),
             byte_from_color(color[2]));
    plot_text(plot, "bytes_text", text);
    plot_direction(plot, "color", color);
}

// What becomes of one of the spheres.
static void say_sphere(const Shown *shown, int k, int sphere, char *text, size_t size)
{
    Sphere s = shown->shot.scene->spheres[sphere];
    Text name = sphere_name(sphere);
    if (hit_sphere(shown->ray, s) < NO_HIT)
        snprintf(text, size, "%s: $t$ = {root_0_%d}, {root_1_%d}", name.s, k, k);
    else
        snprintf(text, size, "%s: %s", name.s,
                 sphere_roots(shown->ray, s).count > 0 ? "behind the eye" : "missed");
}

// The story in three blocks of words below the picture: the ray, its hits, the colour.
static void say(Plot *plot, const Shown *shown, const Outcome *outcome)
{
    const Label ray[] = {{"pixel {pixel} of {size}", "ink", .step = 1},
                         {"$s$ = {s}, $t$ = {t}", "ink", .step = 1},
                         {"$v$ = {vector_v}", "blue", .step = 2}};
    Label hits[MOST_DRAWN];
    char texts[MOST_DRAWN][240];
    for (int i = 0; i < outcome->told_count; i++) {
        say_sphere(shown, i + 1, outcome->told[i], texts[i], sizeof texts[i]);
        hits[i] = (Label){texts[i], "ink", .step = 4};
    }
    char nearest[200] = "no hit: background";
    if (shown->hit_count > 0)
        snprintf(nearest, sizeof nearest, "smallest $t$: {nearest}, %s",
                 sphere_name(shown->hits[0].sphere).s);
    const Label color[] = {{nearest, "blue", .step = 5}, {"colour {bytes}", "ink", .step = 6}};
    plot_say(plot, 0, 0, ray, 3);
    plot_say(plot, 1, 0, color, 2);
    if (outcome->told_count > 0)
        plot_say(plot, 0.52, 0, hits, outcome->told_count);
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
