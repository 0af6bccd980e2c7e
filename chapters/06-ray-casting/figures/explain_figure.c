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
}
