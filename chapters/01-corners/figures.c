// figures.c - what the figures of chapter 01 show, in numbers.
#include "chapters/01-corners/figures.h"

#include "chapters/01-corners/plane.h"
#include "common/beside.h"
#include "exercises/01-corners.h"

// The legs of the way to both upper corners: ahead to the middle, half a width aside, half a height
// up; each as the difference of two vectors of exercise 01.
static void corner_vectors(Plot *plot, void *given)
{
    const View *view = given;
    Camera c = view->camera;
    vec3 middle = image_plane_vector(c, 0.5, 0.5);
    vec3 left = image_plane_vector(c, 0, 0.5), right = image_plane_vector(c, 1, 0.5);
    plane_data(plot, c, 8, 8);
    plot_vector(plot, "ahead", c.origin, middle);
    plot_vector(plot, "aside_left", c.origin + middle, left - middle);
    plot_vector(plot, "aside_right", c.origin + middle, right - middle);
    plot_vector(plot, "up_left", c.origin + left, image_plane_vector(c, 0, 1) - left);
    plot_vector(plot, "up_right", c.origin + right, image_plane_vector(c, 1, 1) - right);
    plot_vector(plot, "upper_left", c.origin, upper_left(c));
    plot_vector(plot, "upper_right", c.origin, upper_right(c));
}

// An example: the point 30% across and 10% up, and who counts from the middle of the plane, which
// is half a width and half a height from the corner.
static void yours_and_right(Plot *plot, void *given)
{
    const View *view = given;
    Camera c = view->camera;
    vec3 right = across_30_up_10(c), yours = view->yours;
    bool example = isnan(yours[0]);
    if (example)
        yours = image_plane_vector(c, 0.3 + 0.5, 0.1 + 0.5);
    plane_data(plot, c, 8, 8);
    plot_text(plot, "asked", "across_30_up_10");
    plot_text(plot, "why", example ? "Is (0, 0) the corner or the centre?" : "");
    beside_vectors(plot, c.origin, right, c.origin, yours);
    beside_words(plot, vec3_text(right).s, vec3_text(yours).s, beside_off(c, yours - right).s);
}

static const Figure figures[] = {
    {"corner-vectors", corner_vectors}, {"yours-and-right", yours_and_right}, {0}};

int corners_figure(const char *program, FigureCommand command, const View *view)
{
    View copy = *view;
    return plot_figure(program, "chapters/01-corners", figures, command, &copy);
}
