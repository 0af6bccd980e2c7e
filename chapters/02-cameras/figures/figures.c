// figures.c - the numbers that the figures of chapter 02 show.
#include "chapters/02-cameras/figures/figures.h"

#include "chapters/02-cameras/forms.h"
#include "chapters/shared/camera_drawing.h"
#include "common/text.h"
#include "exercises/01-corners.h"
#include "exercises/02-cameras.h"

#include <stdio.h>
#include <string.h>

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

// FORM_found_text: its d, w and h.
static void plot_words(Plot *plot, Found found)
{
    Text words = {"no camera"};
    if (found.fault == CAMERA_OK)
        words = text_of("d = %s, w = %s, h = %s", number_shown(found.camera.distance).s,
                        number_shown(found.camera.width).s, number_shown(found.camera.height).s);
    plot_label(plot, text_of("%s_found", found.form).s, words.s);
}

// Of the arrows of a frame that is drawn at the middle of the plane.
static double frame_length(Camera c)
{
    return fmax(c.distance, fmax(c.width, c.height)) / 5;
}

// The plane of a camera that was found, and its frame at the middle of it, in a form's panel:
// $found1, $frame1.
static void plot_found(Plot *plot, Found found, int form)
{
    Camera c = found.camera;
    vec3 middle = c.origin + image_plane_vector(c, 0.5, 0.5);
    double length = frame_length(c);
    plot_words(plot, found);
    plane_outline(plot, text_of("found%d", form + 1).s, c);
    plot_block(plot, text_of("frame%d", form + 1).s,
               "x y z of the plane's middle, x y z of an arrow: right, up, forward");
    plot_row_vector(plot, middle, length * c.right);
    plot_row_vector(plot, middle, length * c.up);
    plot_row_vector(plot, middle, length * c.forward);
}

// The letters of the frame, where there is room for them; in the other panels, colors say which.
static void name_frame(Plot *plot)
{
    plot_names(plot, {"$r$", "orange", .step = 5, .block = "frame1", .part = 1},
               {"$u$", "green", .step = 5, .block = "frame1", .row = 1, .part = 1},
               {"$f$", "pink", .step = 5, .block = "frame1", .row = 2, .part = 1});
}

// What each panel has: the eye, and a part of the canvas of its own, under its title.
static void begin_panel(Plot *plot, Given given, int form, const char *title)
{
    double left = form % 2 == 0 ? 0.02 : 0.51, bottom = form < 2 ? 0.465 : 0.075;
    Room room = {left, left + 0.47, bottom, bottom + 0.335};
    Camera c = given.camera;
    Text block = text_of("eye%d", form + 1);
    plot_panel(plot, form + 1);
    plot_room(plot, room, room);
    plot_point(plot, block.s, c.origin);
    plot_fit(plot, c.origin, 0);
    plot_fit(plot, c.origin + (c.distance + frame_length(c)) * c.forward, 0);
    if (form == 0)
        plot_name(plot, (Label){"eye", "blue", .step = 1, .block = block.s});
    plot_pin(plot, form % 2 == 0 ? 0.25 : 0.75, form < 2 ? 0.97 : 0.502,
             {title, "ink", .step = form + 1});
}

enum { LINE = 104 }; // whose camera it is, a space, and its words

// Whose camera it is, and its words: in a line, or in two where the narrow canvas is too narrow.
// Returns how many.
static int result_lines(Plot *plot, const char *who, const char *found, Label lines[2],
                        char line[LINE])
{
    enum { WIDEST = 690 };
    snprintf(line, LINE, "%s %s", who, found);
    bool fits = plot_width(plot, line) <= WIDEST;
    lines[0] = (Label){fits ? line : who, "grey", .step = 5};
    lines[1] = (Label){found, "grey", .step = 5};
    return fits ? 1 : 2;
}

// All forms give one camera. If your answers give another one, the first of those is below it.
static void plot_results(Plot *plot, const Found *found, int count)
{
    static const char *const titles[] = {"look-at", "points", "corner", "vectors"};
    char name[40], who[40], given[60], right[LINE], yours[LINE];
    Label lines[4];
    int used = result_lines(plot, "each gives", "{look_at_found}", lines, right), first = used;
    for (int i = 0; i < count && used == first; i++) {
        snprintf(name, sizeof name, "%s_found", found[i].form);
        if (plot_says_yours(plot, name)) {
            snprintf(who, sizeof who, "yours, %s:", titles[i]);
            snprintf(given, sizeof given, "{your_%s}", name);
            used += result_lines(plot, who, given, lines + used, yours);
        }
    }
    plot_pin_of(plot, 0.5, 0.035 * used, used, lines);
}

static void look_at_panel(Plot *plot, Forms forms)
{
    LookAt view = forms.look_at;
    vec3 up = vec3_length(view.at - view.eye) / 4 * vec3_unit(view.up);
    plot_point(plot, "at", view.at);
    plot_direction(plot, "look_up", view.up);
    plot_number(plot, "aspect", view.aspect);
    plot_vector(plot, "view", view.eye, view.at - view.eye);
    plot_seen_vector(plot, "up_arrow", view.eye, up);
    plot_names(plot, {"at", "pink", .step = 1, .block = "view", .part = 0.97},
               {"up", "green", .step = 1, .block = "up_arrow", .part = 1});
}

// Four vectors from the eye, or the four points.
static void corners_panel(Plot *plot, const char *block, const vec3 corners[4], vec3 eye, int step)
{
    bool are_points = step == 2;
    plot_block(plot, block,
               are_points ? "x y z of a corner: upper left, right; lower"
                          : "x y z of the eye, x y z to a corner: upper left, right; "
                            "lower");
    for (int i = 0; i < 4; i++) {
        if (are_points)
            plot_row_dot_of(plot, corners[i], 0, NULL);
        else
            plot_row_vector(plot, eye, corners[i]);
    }
}

static void corner_panel(Plot *plot, Forms forms)
{
    plot_point(plot, "lower_left", forms.points.lower_left);
    plot_vector(plot, "across", forms.points.lower_left, forms.across);
    plot_vector(plot, "upward", forms.points.lower_left, forms.upward);
    plot_names(plot, {"across", "orange", .step = 3, .block = "across", .part = 1},
               {"up", "green", .step = 3, .block = "upward", .part = 1});
}

// Each form, and the camera that exercise 02 finds from it.
static void camera_forms(Plot *plot, void *given)
{
    const Given *g = given;
    Camera c = g->camera;
    vec3 eye = c.origin;
    Forms forms = forms_of(c);
    forms.look_at.up = g->up;
    const Corners p = forms.points, v = forms.vectors;
    const vec3 points[] = {p.upper_left, p.upper_right, p.lower_left, p.lower_right};
    const vec3 vectors_to[] = {v.upper_left, v.upper_right, v.lower_left, v.lower_right};

    Camera at = {0}, from_four = {0}, corner = {0}, vectors = {0};
    CameraFault from_at = camera_from_look_at(forms.look_at, handedness_of(c), &at);
    CameraFault from_points = camera_from_points(eye, p, &from_four);
    CameraFault from_corner =
        camera_from_corner(eye, p.lower_left, forms.across, forms.upward, &corner);
    CameraFault from_vectors = camera_from_vectors(eye, v, &vectors);

    Found found[4];
    plot_apart(plot);
    begin_panel(plot, *g, 0, "look-at, $w/h$ = {aspect}");
    plane_data(plot, c, 1, 1);
    look_at_panel(plot, forms);
    found[0] = found_from("look_at", from_at, at, eye);
    plot_found(plot, found[0], 0);
    name_frame(plot);
    camera_handles(plot, c);
    begin_panel(plot, *g, 1, "eye and four points");
    corners_panel(plot, "points", points, eye, 2);
    found[1] = found_from("points", from_points, from_four, eye);
    plot_found(plot, found[1], 1);
    begin_panel(plot, *g, 2, "lower left, two vectors");
    corner_panel(plot, forms);
    found[2] = found_from("corner", from_corner, corner, eye);
    plot_found(plot, found[2], 2);
    begin_panel(plot, *g, 3, "eye and four vectors");
    corners_panel(plot, "vectors", vectors_to, eye, 4);
    found[3] = found_from("vectors", from_vectors, vectors, eye);
    plot_found(plot, found[3], 3);
    plot_results(plot, found, 4);
    plot_look(plot, c.right, c.up, c.forward, 34, 16);
}

// ---- look-at -----------------------------------------------------------------------------------

// The up of the lecture's camera is at right angles to the view already. Here one leans, as most
// do.
static vec3 leaning(Given given)
{
    vec3 up = vec3_unit(isnan(given.lean[0]) ? given.up : given.lean), u = given.camera.up;
    return vec3_length(up - u) > 1e-6 ? up : vec3_unit(u + 0.6 * given.camera.forward);
}

// Of an arrow from the eye: $NAME.
static void from_eye(Plot *plot, const char *name, vec3 eye, vec3 arrow)
{
    plot_vector(plot, name, eye, arrow);
    plot_fit(plot, eye + arrow, 0);
}

// Panel 1: the frame at the eye, of arrows that are 1 long, and the plane of f and the given up.
static void frame_panel(Plot *plot, Camera c, vec3 up, Camera found)
{
    vec3 eye = c.origin, f = c.forward, u = c.up;
    bool is_right_handed = handedness_of(c) == RIGHT_HANDED;
    plot_room(plot, (Room){0.03, 0.55, 0.05, 0.58}, (Room){0.03, 0.55, 0.05, 0.58});
    plot_point(plot, "eye", eye);
    plot_block(plot, "sheet", "x y z round a part of the plane of f and the given up");
    const double round[5][2] = {{0, 0}, {1.2, 0}, {1.2, 1.2}, {0, 1.2}, {0, 0}};
    for (int i = 0; i < 5; i++)
        plot_row_point(plot, eye + round[i][0] * f + round[i][1] * u);
    from_eye(plot, "view", eye, 1.5 * f);
    from_eye(plot, "given_up", eye, up);
    from_eye(plot, "f", eye, found.forward);
    from_eye(plot, "r", eye, found.right);
    from_eye(plot, "u", eye, found.up);
    plot_names(plot, {"eye", "grey", .block = "eye"}, {"to at", "grey", .block = "view", .part = 1},
               {"$f$", "pink", .step = 1, .block = "f", .part = ANYWHERE},
               {"up", "ink", .step = 2, .block = "given_up", .part = 1},
               {"$r$", "orange", .step = 3, .block = "r", .part = 1},
               {"$u$", "green", .step = 4, .block = "u", .part = 1});
    plot_say(plot, 0, 1, {"$f$ from the eye to at", "pink", .step = 1},
             {"up = {lean}", "ink", .step = 2},
             {is_right_handed ? "$r$ along $f$ × up = {r!}" : "$r$ along up × $f$ = {r!}", "orange",
              .step = 3},
             {is_right_handed ? "$u = r × f$ = {u!}" : "$u = f × r$ = {u!}", "green", .step = 4});
}

// Panel 2: the eye and the image plane from above; half of the width and the distance are the sides
// of a right triangle.
static void angle_panel(Plot *plot, Camera c)
{
    double degrees = 2 * atan2(c.width / 2, c.distance) * 180 / PI;
    double half = width_from_angle(degrees, c.distance) / 2, most = c.width / 2;
    plot_panel(plot, 2);
    plot_look_flat(plot);
    plot_room(plot, (Room){0.62, 0.96, 0.12, 0.62}, (Room){0.62, 0.96, 0.12, 0.62});
    plot_number(plot, "degrees", degrees);
    plot_number(plot, "half_degrees", degrees / 2);
    plot_number(plot, "distance", c.distance);
    plot_number(plot, "half", half);
    plot_point(plot, "corner", vec3_of(0, 0, 0));
    plot_vector(plot, "ahead", vec3_of(0, 0, 0), vec3_of(c.distance, 0, 0));
    plot_vector(plot, "half_width", vec3_of(c.distance, 0, 0), vec3_of(0, half, 0));
    plot_vector(plot, "other_half", vec3_of(c.distance, 0, 0), vec3_of(0, -most, 0));
    plot_vector(plot, "slope", vec3_of(0, 0, 0), vec3_of(c.distance, half, 0));
    plot_vector(plot, "other_slope", vec3_of(0, 0, 0), vec3_of(c.distance, -most, 0));
    plot_fit(plot, vec3_of(0, 0, 0), 0);
    plot_fit(plot, vec3_of(c.distance, most, 0), 0);
    plot_fit(plot, vec3_of(c.distance, -most, 0), 0);
    plot_names(plot, {"eye", "grey", .step = 5, .block = "corner"},
               {"$d$ = {distance}", "pink", .step = 5, .block = "ahead", .part = ANYWHERE},
               {"$w/2$ = {half}", "orange", .step = 5, .block = "half_width", .part = ANYWHERE});
    plot_pin(plot, 0.78, 0.08, {"half the angle: {half_degrees}°", "ink", .step = 5});
    plot_panel(plot, 1);
}

static void look_at(Plot *plot, void *given)
{
    const Given *g = given;
    Camera c = g->camera, found = {0};
    vec3 up = leaning(*g);
    LookAt view = {c.origin, c.origin + c.distance * c.forward, up, c.width, c.width / c.height};
    if (camera_from_look_at(view, handedness_of(c), &found) != CAMERA_OK)
        found = (Camera){.origin = c.origin};
    plot_direction(plot, "right", c.right);
    plot_direction(plot, "up", c.up);
    plot_direction(plot, "forward", c.forward);
    plot_direction(plot, "lean", up);
    plot_look(plot, c.right, c.up, c.forward, 34, 16);
    frame_panel(plot, c, up, found);
    plot_handle_vector(plot, "the up that is given", "lean", c.origin, up, c.forward, c.up);
    angle_panel(plot, c);
}

const Figure camera_figures[] = {{"camera-forms", camera_forms}, {"look-at", look_at}, {0}};
