// figures.c - what the figures of chapter 02 show, in numbers.
#include "chapters/02-cameras/figures.h"

#include "chapters/01-corners/plane.h"
#include "chapters/02-cameras/forms.h"
#include "common/text.h"
#include "exercises/01-corners.h"
#include "exercises/02-cameras.h"

#include <stdio.h>

typedef struct {
    Camera camera;
    vec3 up;
} Given;

static double largest(Camera c)
{
    return fmax(c.distance, fmax(c.width, c.height));
}

static void vector_row(Plot *plot, vec3 from, vec3 v)
{
    plot_row(plot, 6, (const double[]){from[0], from[1], from[2], v[0], v[1], v[2]});
}

// Where a form gives no camera, its plane and frame shrink into the eye.
static Camera shrunk(vec3 eye)
{
    return (Camera){.origin = eye};
}

// $FORM_plane and $FORM_frame, the camera that was found: its outline, and its right, up and
// forward from the middle of the plane; FORM_found, its d, w and h in words.
static void plot_found(Plot *plot, const char *form, vec3 eye, CameraFault fault, Camera found)
{
    char name[60];
    Text words;
    Camera c = fault == CAMERA_OK ? found : shrunk(eye);
    vec3 middle = c.origin + image_plane_vector(c, 0.5, 0.5);
    double length = largest(c) / 6;
    snprintf(name, sizeof name, "%s_plane", form);
    plane_outline(plot, name, c);
    snprintf(name, sizeof name, "%s_frame", form);
    plot_block(plot, name, "x y z of the middle, x y z of an arrow: right, up, forward");
    vector_row(plot, middle, length * c.right);
    vector_row(plot, middle, length * c.up);
    vector_row(plot, middle, length * c.forward);
    plot_block_end(plot);
    if (fault == CAMERA_OK)
        snprintf(words.s, sizeof words.s, "d = %.40s, w = %.40s, h = %.40s",
                 number_text_to(c.distance, 4).s, number_text_to(c.width, 4).s,
                 number_text_to(c.height, 4).s);
    else
        snprintf(words.s, sizeof words.s, "no camera: %.100s", camera_fault_text(fault));
    snprintf(name, sizeof name, "%s_found", form);
    plot_text(plot, name, words.s);
}

static void plot_look_at(Plot *plot, LookAt view, Handedness hand)
{
    plot_point(plot, "at", view.at);
    plot_direction(plot, "look_up", view.up);
    plot_vector(plot, "up_arrow", view.eye,
                vec3_length(view.at - view.eye) / 4 * vec3_unit(view.up));
    plot_vector(plot, "view", view.eye, view.at - view.eye);
    plot_number(plot, "aspect", view.aspect);
    Camera found = {0};
    CameraFault fault = camera_from_look_at(view, hand, &found);
    plot_found(plot, "look_at", view.eye, fault, found);
}

static void plot_points(Plot *plot, vec3 eye, Corners points)
{
    const vec3 corners[] = {points.upper_left, points.upper_right, points.lower_left,
                            points.lower_right};
    plot_block(plot, "points", "x y z: upper left, upper right, lower left, lower right");
    for (int i = 0; i < 4; i++)
        plot_row(plot, 3, (const double[]){corners[i][0], corners[i][1], corners[i][2]});
    plot_block_end(plot);
    Camera found = {0};
    CameraFault fault = camera_from_points(eye, points, &found);
    plot_found(plot, "points", eye, fault, found);
}

static void plot_corner(Plot *plot, vec3 eye, Forms forms)
{
    vec3 corner = forms.points.lower_left;
    plot_point(plot, "lower_left", corner);
    plot_vector(plot, "across", corner, forms.across);
    plot_vector(plot, "upward", corner, forms.upward);
    Camera found = {0};
    CameraFault fault = camera_from_corner(eye, corner, forms.across, forms.upward, &found);
    plot_found(plot, "corner", eye, fault, found);
}

static void plot_vectors(Plot *plot, vec3 eye, Corners vectors)
{
    plot_block(plot, "vectors", "x y z of the eye, x y z to the corners, in the order of $points");
    vector_row(plot, eye, vectors.upper_left);
    vector_row(plot, eye, vectors.upper_right);
    vector_row(plot, eye, vectors.lower_left);
    vector_row(plot, eye, vectors.lower_right);
    plot_block_end(plot);
    Camera found = {0};
    CameraFault fault = camera_from_vectors(eye, vectors, &found);
    plot_found(plot, "vectors", eye, fault, found);
}

// Each form as it is given, and the camera that exercise 02 finds from it.
static void camera_forms(Plot *plot, void *given)
{
    const Given *g = given;
    Camera c = g->camera;
    Forms forms = forms_of(c);
    forms.look_at.up = g->up;
    plane_data(plot, c, 1, 1);
    plot_look_at(plot, forms.look_at, hand_of(c));
    plot_points(plot, c.origin, forms.points);
    plot_corner(plot, c.origin, forms);
    plot_vectors(plot, c.origin, forms.vectors);
}

static const Figure figures[] = {{"camera-forms", camera_forms}, {0}};

int cameras_figure(const char *program, FigureCommand command, Camera camera, vec3 up)
{
    Given given = {camera, up};
    return plot_figure(program, "chapters/02-cameras", figures, command, &given);
}
