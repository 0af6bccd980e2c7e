// figures.c - the numbers that the figure of chapter 04 shows: the chain, one function for each
// link.
#include "chapters/04-pixel-ray/figures/figures.h"

#include "chapters/shared/camera_drawing.h"
#include "chapters/shared/digits.h"
#include "exercises/01-corners.h"
#include "exercises/03-screen.h"
#include "exercises/04-pixel-ray.h"

#include <stdio.h>

// The length of the drawn ray, as a multiple of the vector to the image plane.
#define FAR 1.5

// The places of pixels and points in the unit of their panel: y and row count down, so they are
// drawn below 0.
static vec3 flat(double x, double y)
{
    return vec3_of(x, y, 0);
}

// A rectangle, and strokes from its left edge and from its upper or lower edge to a point in it.
static void flat_panel(Plot *plot, const char *name, vec3 corner, vec3 size, vec3 point,
                       bool from_below)
{
    plot_block(plot, name, "x y z of the corners");
    for (int i = 0; i < 5; i++)
        plot_row_point(
            plot, corner + flat(i == 1 || i == 2 ? size[0] : 0, i == 2 || i == 3 ? size[1] : 0));
    plot_fit(plot, corner, 0);
    plot_fit(plot, corner + size, 0);
    plot_point(plot, text_of("%s_point", name).s, point);
    plot_vector(plot, text_of("%s_across", name).s, flat(corner[0], point[1]),
                flat(point[0] - corner[0], 0));
    double edge = from_below ? corner[1] : corner[1] + size[1];
    plot_vector(plot, text_of("%s_up", name).s, flat(point[0], edge), flat(0, point[1] - edge));
}

// Panels 2, 3 and 4, side by side: the pixel under a lens, the screen, the unit square.
static void chain(Plot *plot, const Aim *aim, ScreenPoint center, Normalized place)
{
    const double column = aim->pixel.column, row = aim->pixel.row;
    vec3 size = flat(aim->screen.width, aim->screen.height), middle = flat(center.x, -center.y);
    plot_panel(plot, 2);
    plot_look_flat(plot);
    plot_room(plot, (Room){0.03, 0.18, 0.62, 0.845}, (Room){0.03, 0.23, 0.62, 0.845});
    flat_panel(plot, "lens", flat(column, -row - 1), flat(1, 1), middle, false);
    plot_name(plot,
              (Label){"pixel", "ink", .step = 1, .block = "lens", .row = 3, .part = ANYWHERE});
    plot_panel(plot, 3);
    plot_room(plot, (Room){0.22, 0.40, 0.62, 0.845}, (Room){0.29, 0.57, 0.62, 0.845});
    flat_panel(plot, "display", flat(0, -size[1]), size, middle, false);
    // The rims of the lens.
    plot_line_from(plot, 2, flat(column + 1, -row), flat(column, -row));
    plot_line_from(plot, 2, flat(column + 1, -row - 1), flat(column, -row - 1));
    plot_name(plot,
              (Label){"screen", "ink", .step = 1, .block = "display", .row = 3, .part = ANYWHERE});
    plot_panel(plot, 4);
    plot_room(plot, (Room){0.48, 0.61, 0.62, 0.845}, (Room){0.72, 0.95, 0.62, 0.845});
    flat_panel(plot, "unit", flat(0, 0), flat(1, 1), flat(place.s, place.t), true);
    plot_name(plot, (Label){"$(s, t)$", "blue", .step = 3, .block = "unit_point"});
    // The arrow between them, which the layout draws.
    plot_keep_clear(plot, (Room){0.40, 0.48, 0.66, 0.74}, (Room){0.57, 0.72, 0.66, 0.74});
    plot_panel(plot, 1);
}

// In the world. Returns the vector to the place.
static vec3 vector_data(Plot *plot, Camera c, Normalized place)
{
    vec3 there = image_plane_vector(c, place.s, place.t);
    vec3 left = image_plane_vector(c, 0, place.t), below = image_plane_vector(c, place.s, 0);
    plot_vector(plot, "vector", c.origin, there);
    plot_label(plot, "v", vec3_shown(there).s);
    plot_vector(plot, "along_s", c.origin + left, there - left);
    plot_vector(plot, "along_t", c.origin + below, there - below);
    // A wrong place may be far away, and would make everything else too small to see.
    if (fabs(place.s - 0.5) <= 0.5 && fabs(place.t - 0.5) <= 0.5)
        plot_fit(plot, c.origin + FAR * there, 0);
    plot_names(plot, {"$p$", "blue", .step = 4, .block = "eye"},
               {"$v$", "blue", .step = 4, .block = "vector", .part = 0.4},
               {"$p + t v$", "blue", .step = 5, .block = "ray", .part = 1});
    return there;
}

// Of the user's answers, the first link of the chain that is wrong.
static void yours(Plot *plot, ScreenPoint center, Text place, vec3 vector, vec3 origin)
{
    const struct {
        const char *name, *words;
        Text value;
    } links[] = {{"center", "center", pair_shown(center.x, center.y)},
                 {"place", "(s, t) =", place},
                 {"v", "v =", vec3_shown(vector)},
                 {"origin", "p =", vec3_shown(origin)}};
    for (size_t i = 0; i < sizeof links / sizeof *links; i++)
        if (plot_says_yours(plot, links[i].name)) {
            plot_below(plot, "ink", text_of("yours: %s %s", links[i].words, links[i].value.s).s);
            return;
        }
}

static void pixel_handle(Plot *plot, const Aim *aim, vec3 vector)
{
    Camera c = aim->camera;
    vec3 corner = image_plane_vector(c, 0, 1);
    plot_handle_pixel(plot, c.origin + vector, aim->pixel, aim->screen,
                      (image_plane_vector(c, 1, 1) - corner) / aim->screen.width,
                      (image_plane_vector(c, 0, 0) - corner) / aim->screen.height);
}

static void pixel_to_ray(Plot *plot, void *given)
{
    const Aim *aim = given;
    Camera c = aim->camera;
    ScreenPoint center = pixel_center(aim->pixel);
    Normalized place = screen_to_normalized(center, aim->screen);
    Ray ray = ray_to_plane(pixel_ray(c, aim->screen, aim->pixel), c);
    int digits = place_digits(aim->screen);
    plot_look(plot, c.right, c.up, c.forward, 28, 16);
    plot_room(plot, (Room){0.03, 0.61, 0.04, 0.58}, (Room){0.03, 0.97, 0.28, 0.60});
    plane_data(plot, c, 1, 1);
    plot_pair(plot, "screen", "W", aim->screen.width, "H", aim->screen.height);
    plot_pair(plot, "pixel", "column", aim->pixel.column, "row", aim->pixel.row);
    plot_pair(plot, "center", "x", center.x, "y", center.y);
    plot_pair_to(plot, "place", "s", place.s, "t", place.t, digits);
    plot_point(plot, "origin", ray.origin);
    plot_vector(plot, "ray", ray.origin, FAR * ray.direction);
    vec3 vector = vector_data(plot, c, place);
    chain(plot, aim, center, place);
    plot_say(plot, 0.82, 1, {"pixel {pixel}", "ink", .step = 1},
             {"center {center}", "ink", .step = 2},
             {"$s = x/${screen_W} = {place_s}", "orange", .step = 3},
             {"$t = 1 − y/${screen_H} = {place_t}", "green", .step = 3});
    plot_say(plot, 1, 0, {"$v = d f + (s − ½) w r$", "blue", .step = 4},
             {"$+ (t − ½) h u$", "blue", .step = 4}, {"= {vector}", "blue", .step = 4},
             {"ray $p + t v$ from", "blue", .step = 5}, {"{origin}", "blue", .step = 5});
    yours(plot, center, pair_shown_to(place.s, place.t, digits), vector, ray.origin);
    pixel_handle(plot, aim, vector);
    camera_handles(plot, c);
}

const Figure pixel_ray_figures[] = {{"pixel-to-ray", pixel_to_ray}, {0}};
