// figures.c - the numbers that the figure of chapter 04 shows: the chain, one function for each
// link.
#include "chapters/04-pixel-ray/figures/figures.h"

#include "chapters/shared/camera_drawing.h"
#include "common/text.h"
#include "exercises/01-corners.h"
#include "exercises/03-screen.h"
#include "exercises/04-pixel-ray.h"

// The length of the drawn ray, as a multiple of the vector to the image plane.
#define FAR 1.5

static void vector_data(Plot *plot, Camera c, Normalized place)
{
    vec3 there = image_plane_vector(c, place.s, place.t);
    vec3 left = image_plane_vector(c, 0, place.t), below = image_plane_vector(c, place.s, 0);
    plot_vector(plot, "vector", c.origin, there);
    plot_label(plot, "v", vec3_text(there).s);
    plot_vector(plot, "along_s", c.origin + left, there - left);
    plot_vector(plot, "along_t", c.origin + below, there - below);
    // A wrong place may be far away, and would make everything else too small to see.
    if (fabs(place.s - 0.5) <= 0.5 && fabs(place.t - 0.5) <= 0.5)
        plot_fit(plot, c.origin + FAR * there, 0);
}

static void pixel_to_ray(Plot *plot, void *given)
{
    const Aim *aim = given;
    Camera c = aim->camera;
    ScreenPoint center = pixel_center(aim->pixel);
    Normalized place = screen_to_normalized(center, aim->screen);
    Ray ray = ray_to_plane(pixel_ray(c, aim->screen, aim->pixel), c);
    plane_data(plot, c, 1, 1);
    plot_pair(plot, "screen", "W", aim->screen.width, "H", aim->screen.height);
    plot_pair(plot, "pixel", "column", aim->pixel.column, "row", aim->pixel.row);
    plot_pair(plot, "center", "x", center.x, "y", center.y);
    plot_pair(plot, "place", "s", place.s, "t", place.t);
    vector_data(plot, c, place);
    plot_point(plot, "origin", ray.origin);
    plot_vector(plot, "ray", ray.origin, FAR * ray.direction);
}

static const Figure figures[] = {{"pixel-to-ray", pixel_to_ray}, {0}};

int pixel_ray_figure(const char *program, FigureCommand command, const Aim *aim)
{
    Aim copy = *aim;
    return plot_figure(program, "chapters/04-pixel-ray", figures, command, &copy);
}
