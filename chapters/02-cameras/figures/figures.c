// figures.c - the numbers that the figures of chapter 02 show.
#include "chapters/02-cameras/figures/figures.h"

#include "chapters/02-cameras/forms.h"
#include "chapters/shared/camera_drawing.h"
#include "common/text.h"
#include "exercises/01-corners.h"
#include "exercises/02-cameras.h"

#include <stdio.h>

typedef struct {
    Camera camera;
    vec3 up;
} Given;

// A camera that exercise 02 found from a form. If it was refused, the plane is one point, the eye.
typedef struct {
    const char *form;
    CameraFault fault;
    Camera camera;
} Found;

static Found found_from(const char *form, CameraFault fault, Camera camera, vec3 eye)
{
    return (Found){form, fault, fault == CAMERA_OK ? camera : (Camera){.origin = eye}};
}

// FORM_found: its d, w and h.
static void plot_words(Plot *plot, Found found)
{
    char name[60];
    Text words;
    if (found.fault == CAMERA_OK)
        snprintf(words.s, sizeof words.s, "d = %.40s, w = %.40s, h = %.40s",
                 number_text_to(found.camera.distance, 4).s,
                 number_text_to(found.camera.width, 4).s, number_text_to(found.camera.height, 4).s);
    else
        snprintf(words.s, sizeof words.s, "no camera");
    snprintf(name, sizeof name, "%s_found", found.form);
    plot_text(plot, name, words.s);
}

// $planes and $frames of all cameras that were found, with an empty line between two cameras.
static void plot_found(Plot *plot, const Found *found, int count)
{
    for (int i = 0; i < count; i++)
        plot_words(plot, found[i]);
    plot_block(plot, "planes", "x y z of the corners, starting at the upper left");
    for (int i = 0; i < count; i++) {
        if (i > 0)
            plot_gap(plot);
        plane_rows(plot, found[i].camera);
    }
    plot_block_end(plot);
    plot_block(plot, "frames",
               "x y z of the plane's middle, x y z of an arrow: right, up, forward");
    for (int i = 0; i < count; i++) {
        Camera c = found[i].camera;
        vec3 middle = c.origin + image_plane_vector(c, 0.5, 0.5);
        double length = fmax(c.distance, fmax(c.width, c.height)) / 5;
        if (i > 0)
            plot_gap(plot);
        plot_row_vector(plot, middle, length * c.right);
        plot_row_vector(plot, middle, length * c.up);
        plot_row_vector(plot, middle, length * c.forward);
    }
    plot_block_end(plot);
}

// The given numbers, form by form.
static void plot_forms(Plot *plot, vec3 eye, Forms forms)
{
    LookAt view = forms.look_at;
    vec3 up = vec3_length(view.at - view.eye) / 4 * vec3_unit(view.up);
    plot_point(plot, "at", view.at);
    plot_direction(plot, "look_up", view.up);
    plot_number(plot, "aspect", view.aspect);
    plot_vector(plot, "view", view.eye, view.at - view.eye);
    plot_vector(plot, "up_arrow", view.eye, up);
    plot_fit(plot, view.eye + 1.2 * up, 0);

    plot_block(plot, "vectors", "x y z of the eye, x y z to a corner: upper left, right; lower");
    plot_row_vector(plot, eye, forms.vectors.upper_left);
    plot_row_vector(plot, eye, forms.vectors.upper_right);
    plot_row_vector(plot, eye, forms.vectors.lower_left);
    plot_row_vector(plot, eye, forms.vectors.lower_right);
    plot_block_end(plot);
    plot_point(plot, "upper_left", forms.points.upper_left);
    plot_point(plot, "upper_right", forms.points.upper_right);
    plot_point(plot, "lower_left", forms.points.lower_left);
    plot_point(plot, "lower_right", forms.points.lower_right);
    plot_vector(plot, "across", forms.points.lower_left, forms.across);
    plot_vector(plot, "upper_edge", forms.points.upper_left, forms.across);
    plot_vector(plot, "upward", forms.points.lower_left, forms.upward);
}

// Each form, and the camera that exercise 02 finds from it.
static void camera_forms(Plot *plot, void *given)
{
    const Given *g = given;
    Camera c = g->camera;
    vec3 eye = c.origin;
    Forms forms = forms_of(c);
    forms.look_at.up = g->up;
    plane_data(plot, c, 1, 1);
    plot_forms(plot, eye, forms);

    Camera at = {0}, points = {0}, corner = {0}, vectors = {0};
    CameraFault from_at = camera_from_look_at(forms.look_at, hand_of(c), &at);
    CameraFault from_points = camera_from_points(eye, forms.points, &points);
    CameraFault from_corner =
        camera_from_corner(eye, forms.points.lower_left, forms.across, forms.upward, &corner);
    CameraFault from_vectors = camera_from_vectors(eye, forms.vectors, &vectors);
    const Found found[] = {found_from("look_at", from_at, at, eye),
                           found_from("points", from_points, points, eye),
                           found_from("corner", from_corner, corner, eye),
                           found_from("vectors", from_vectors, vectors, eye)};
    plot_found(plot, found, 4);
}

static const Figure figures[] = {{"camera-forms", camera_forms}, {0}};

int cameras_figure(const char *program, FigureCommand command, Camera camera, vec3 up)
{
    Given given = {camera, up};
    return plot_figure(program, "chapters/02-cameras", figures, command, &given);
}
