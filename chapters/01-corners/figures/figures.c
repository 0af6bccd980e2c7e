// figures.c - the numbers that the figures of chapter 01 show.
#include "chapters/01-corners/figures/figures.h"

#include "chapters/shared/camera_drawing.h"
#include "exercises/01-corners.h"

#include <string.h>

static double largest(Camera c)
{
    return fmax(c.distance, fmax(c.width, c.height));
}

// ---- the camera -------------------------------------------------------------------------------

// Dimensions are beside their edges, in units of the canvas: above, or to the right.
enum { GAP = 14 };

// An arrow from one place on the plane to another.
static void plot_edge(Plot *plot, const char *name, Camera c, vec3 from, vec3 to)
{
    plot_vector(plot, name, c.origin + from, to - from);
}

// The world's axes go through the origin and along the whole camera. If the origin is too far away
// to show both, three short arrows below the camera show only the directions.
static void world_axes(Plot *plot, Camera c)
{
    static const char *const names[] = {"x_axis", "y_axis", "z_axis"};
    double size = largest(c);
    bool far = vec3_length(c.origin + c.distance * c.forward) > 1.5 * size;
    vec3 below = c.origin + 0.4 * c.distance * c.forward - (0.2 * c.height + 0.4 * size) * c.up;
    plot_number(plot, "origin_is_far", far);
    for (int i = 0; i < 3; i++) {
        vec3 direction = vec3_of(i == 0, i == 1, i == 2);
        if (far) {
            plot_seen_vector(plot, names[i], below, size / 6 * direction);
            continue;
        }
        double half = (c.width * fabs(c.right[i]) + c.height * fabs(c.up[i])) / 2;
        double middle = c.origin[i] + c.distance * c.forward[i];
        double low = fmin(0, fmin(c.origin[i], middle - half));
        double high = fmax(0, fmax(c.origin[i], middle + half));
        plot_seen_vector(plot, names[i], low * direction, (high + size / 8 - low) * direction);
    }
}

// The arrows are a quarter of the camera long: 1 if d is 4, the length of a unit vector.
static void frame_arrows(Plot *plot, Camera c)
{
    const vec3 frame[] = {c.right, c.up, c.forward};
    static const char *const names[] = {"right_arrow", "up_arrow", "forward_arrow"};
    for (int i = 0; i < 3; i++)
        plot_seen_vector(plot, names[i], c.origin, largest(c) / 4 * frame[i]);
}

static void camera_frame(Plot *plot, void *given)
{
    Camera c = ((const View *)given)->camera;
    vec3 lower_left = image_plane_vector(c, 0, 0), lower_right = image_plane_vector(c, 1, 0);
    vec3 corners[] = {upper_left(c), upper_right(c), lower_left, lower_right};
    plane_data(plot, c, 8, 8);
    world_axes(plot, c);
    frame_arrows(plot, c);
    plot_vector(plot, "ahead", c.origin, image_plane_vector(c, 0.5, 0.5));
    plot_moved(plot, 0, GAP);
    plot_edge(plot, "upper_edge", c, image_plane_vector(c, 0, 1), image_plane_vector(c, 1, 1));
    plot_moved(plot, GAP, 0);
    plot_edge(plot, "right_edge", c, lower_right, image_plane_vector(c, 1, 1));
    plot_block(plot, "to_corners", "x y z of the eye, x y z of the vector to a corner");
    for (int i = 0; i < 4; i++)
        plot_row_vector(plot, c.origin, corners[i]);
    plot_look(plot, c.right, c.up, c.forward, 32, 16);
    plot_names(plot, {"$p$", "blue", .block = "eye"},
               {"$r$", "orange", .block = "right_arrow", .part = 1},
               {"$u$", "green", .block = "up_arrow", .part = 1},
               {"$f$", "pink", .block = "forward_arrow", .part = ANYWHERE},
               {"$d$ = {d}", "pink", .step = 2, .block = "ahead", .part = 0.55},
               {"$w$ = {w}", "orange", .step = 2, .block = "upper_edge", .part = ANYWHERE},
               {"$h$ = {h}", "green", .step = 2, .block = "right_edge", .part = ANYWHERE},
               {"$x$", "grey", .block = "x_axis", .part = 1},
               {"$y$", "grey", .block = "y_axis", .part = 1},
               {"$z$", "grey", .block = "z_axis", .part = 1});
    camera_handles(plot, c);
}

// The place s across and t up.
static void place_handle(Plot *plot, const View *view)
{
    Camera c = view->camera;
    vec3 corner = image_plane_vector(c, 0, 0);
    plot_handle(plot, (Handle){.words = "the place on the image plane: s and t",
                               .place = c.origin + image_plane_vector(c, view->s, view->t),
                               .option = {"s", "t"},
                               .count = 2,
                               .value = vec3_of(view->s, view->t, 0),
                               .along = {image_plane_vector(c, 1, 0) - corner,
                                         image_plane_vector(c, 0, 1) - corner},
                               .most = {1, 1}});
}

// ---- vectors to the plane ---------------------------------------------------------------------

// The steps to both upper corners: forward to the middle, half a width sideways, half a
// height up. Each step is the difference of two vectors of exercise 01.
static void corner_vectors(Plot *plot, void *given)
{
    Camera c = ((const View *)given)->camera;
    vec3 middle = image_plane_vector(c, 0.5, 0.5);
    vec3 left = image_plane_vector(c, 0, 0.5), right = image_plane_vector(c, 1, 0.5);
    plane_data(plot, c, 8, 8);
    plot_vector(plot, "ahead", c.origin, middle);
    plot_edge(plot, "aside_left", c, middle, left);
    plot_edge(plot, "aside_right", c, middle, right);
    plot_edge(plot, "up_left", c, left, image_plane_vector(c, 0, 1));
    plot_edge(plot, "up_right", c, right, image_plane_vector(c, 1, 1));
    plot_vector(plot, "upper_left", c.origin, upper_left(c));
    plot_vector(plot, "upper_right", c.origin, upper_right(c));
    plot_look(plot, c.right, c.up, c.forward, 34, 16);
    plot_names(plot, {"$p$", "blue", .block = "eye"},
               {"$d f$", "pink", .block = "ahead", .part = ANYWHERE},
               {"$−(w/2) r$", "orange", .step = 2, .block = "aside_left", .part = ANYWHERE},
               {"$+(h/2) u$", "green", .step = 2, .block = "up_left", .part = ANYWHERE},
               {"$d f − (w/2) r + (h/2) u$\n= {upper_left}", "blue", .step = 3,
                .block = "upper_left", .part = 1},
               {"$+(w/2) r$", "orange", .step = 4, .block = "aside_right", .part = ANYWHERE},
               {"$+(h/2) u$", "green", .step = 4, .block = "up_right", .part = ANYWHERE},
               {"$d f + (w/2) r + (h/2) u$\n= {upper_right}", "blue", .step = 5,
                .block = "upper_right", .part = 1});
    camera_handles(plot, c);
}

// The point s across and t up: its parts of the edges, and the steps to it. The slide's
// point, 30% and 10%, comes from the function that answers the slide's question.
static void point_30_10(Plot *plot, void *given)
{
    const View *view = given;
    Camera c = view->camera;
    double s = view->s, t = view->t;
    vec3 middle = image_plane_vector(c, 0.5, 0.5), aside = image_plane_vector(c, s, 0.5);
    bool slide = s == 0.3 && t == 0.1;
    vec3 v = slide ? across_30_up_10(c) : image_plane_vector(c, s, t);
    plane_data(plot, c, 10, 10);
    plot_number(plot, "s", s);
    plot_number(plot, "t", t);
    plot_number(plot, "percent_across", 100 * s);
    plot_number(plot, "percent_up", 100 * t);
    plot_moved(plot, 0, -GAP);
    plot_edge(plot, "across", c, image_plane_vector(c, 0, 0), image_plane_vector(c, s, 0));
    plot_moved(plot, GAP, 0);
    plot_edge(plot, "upward", c, image_plane_vector(c, 1, 0), image_plane_vector(c, 1, t));
    plot_edge(plot, "column", c, image_plane_vector(c, s, 0), image_plane_vector(c, s, t));
    plot_edge(plot, "row", c, image_plane_vector(c, 1, t), image_plane_vector(c, s, t));
    plot_vector(plot, "ahead", c.origin, middle);
    plot_edge(plot, "aside", c, middle, aside);
    plot_edge(plot, "up_or_down", c, aside, image_plane_vector(c, s, t));
    plot_seen_vector(plot, "vector", c.origin, v);
    plot_look(plot, c.right, c.up, c.forward, 42, 16);
    plot_names(plot, {"$p$", "blue", .block = "eye"},
               {"{percent_across} %", "orange", .block = "across", .part = ANYWHERE},
               {"{percent_up} %", "green", .block = "upward", .part = ANYWHERE},
               {"$d f$", "pink", .step = 2, .block = "ahead", .part = ANYWHERE},
               {"$(s − ½) w r$", "orange", .step = 2, .block = "aside", .part = ANYWHERE},
               {"$(t − ½) h u$", "green", .step = 2, .block = "up_or_down", .part = ANYWHERE},
               {"$d f + (s − ½) w r + (t − ½) h u$\n= {vector}", "blue", .step = 3,
                .block = "vector", .part = 1});
    plot_say(plot, 0, 1, {"$s$ = {s}", "orange", .step = 1}, {"$t$ = {t}", "green", .step = 1});
    place_handle(plot, view);
    camera_handles(plot, c);
}

// ---- doubling ---------------------------------------------------------------------------------

// One camera three times: as it is, doubled, and with distance 1.
static const char *const planes[] = {"plane", "twice_plane", "unit_plane"};
enum { PLANES = 3 };

// The three dimensions of a camera: w above its plane, h beside it, and d below all planes, each at
// a level of its own, between thin lines down from the eye and from the plane's lower edge.
static void dimensions(Plot *plot, Camera c, const char *which, vec3 down)
{
    vec3 corner = image_plane_vector(c, 1, 1);
    plot_moved(plot, 0, GAP);
    plot_edge(plot, text_of("%s_w", which).s, c, image_plane_vector(c, 0, 1), corner);
    plot_moved(plot, GAP, 0);
    plot_edge(plot, text_of("%s_h", which).s, c, image_plane_vector(c, 1, 0), corner);
    vec3 below = image_plane_vector(c, 0.5, 0), end = c.origin + down + c.distance * c.forward;
    plot_seen_vector(plot, text_of("%s_d", which).s, c.origin + down, c.distance * c.forward);
    plot_block(plot, text_of("%s_down", which).s,
               "x y z of a place, x y z of the way down to a dimension");
    plot_row_vector(plot, c.origin, down);
    plot_row_vector(plot, c.origin + below, end - c.origin - below);
}

static void name_dimensions(Plot *plot, const char *which, int step, const char *note,
                            const char *const *names)
{
    static const char *const colors[] = {"pink", "orange", "green"};
    for (int i = 0; i < 3; i++) {
        Text text = text_of("%s$%s$ = {%s}", i == 0 ? note : "", names[2 * i], names[2 * i + 1]);
        Text block = text_of("%s_%c", which, "dwh"[i]);
        plot_name(plot,
                  (Label){text.s, colors[i], .step = step, .block = block.s, .part = ANYWHERE});
    }
}

// Rays go through the corners and through the place s across, t up; they end a little beyond the
// farthest plane.
static void common_rays(Plot *plot, const View *view, double farthest)
{
    Camera c = view->camera;
    const double places[5][2] = {{0, 1}, {1, 1}, {0, 0}, {1, 0}, {view->s, view->t}};
    plot_block(plot, "rays", "x y z of the eye, x y z along a ray");
    for (int i = 0; i < 5; i++) {
        vec3 v = 1.15 * farthest * image_plane_vector(c, places[i][0], places[i][1]);
        plot_row_vector(plot, c.origin, v);
        plot_fit(plot, c.origin + v, 0);
    }
}

static Camera scaled(Camera c, double times)
{
    c.distance *= times;
    c.width *= times;
    c.height *= times;
    return c;
}

static void double_dwh(Plot *plot, void *given)
{
    const View *view = given;
    Camera c = view->camera, twice = scaled(c, 2), unit = with_unit_distance(c);
    // The plane at distance 1 may be a point beside the others, or hide them: then it is elsewhere
    // on the same rays.
    double times = 1 / c.distance, drawn = times > 8 ? 3 : times < 0.08 ? 0.5 : times;
    const Camera cameras[PLANES] = {c, twice, scaled(unit, drawn / times)};
    plane_data(plot, c, 1, 1);
    plane_outline(plot, "twice_plane", twice);
    plane_outline(plot, "unit_plane", cameras[2]);
    plot_number(plot, "s", view->s);
    plot_number(plot, "t", view->t);
    plot_number(plot, "twice_d", twice.distance);
    plot_number(plot, "twice_w", twice.width);
    plot_number(plot, "twice_h", twice.height);
    plot_number(plot, "unit_d", unit.distance);
    plot_number(plot, "unit_w", unit.width);
    plot_number(plot, "unit_h", unit.height);
    plot_number(plot, "to_scale", drawn == times);
    double farthest = fmax(2, drawn);
    common_rays(plot, view, farthest);
    plot_block(plot, "same_place", "x y z of the points where the last ray meets each plane");
    for (int i = 0; i < PLANES; i++)
        plot_row_point(plot, cameras[i].origin + image_plane_vector(cameras[i], view->s, view->t));
    // The longest dimension is the lowest.
    double level = 0.08 * farthest * largest(c), lowest = 0.575 * farthest * c.height;
    for (int i = 0; i < PLANES; i++) {
        int longer = 0;
        for (int k = 0; k < PLANES; k++)
            longer += cameras[k].distance < cameras[i].distance ||
                      (cameras[k].distance == cameras[i].distance && k < i);
        dimensions(plot, cameras[i], planes[i], -(lowest + (longer + 0.4) * level) * c.up);
    }
    plot_look(plot, c.right, c.up, c.forward, 32, 16);
    plot_name(plot, (Label){"$p$", "blue", .block = "eye"});
    name_dimensions(plot, planes[0], 1, "", (const char *[]){"d", "d", "w", "w", "h", "h"});
    name_dimensions(plot, planes[1], 2, "",
                    (const char *[]){"2 d", "twice_d", "2 w", "twice_w", "2 h", "twice_h"});
    name_dimensions(plot, planes[2], 3, drawn == times ? "" : "not to scale: ",
                    (const char *[]){"d/d", "unit_d", "w/d", "unit_w", "h/d", "unit_h"});
    place_handle(plot, view);
    camera_handles(plot, c);
}

// ---- yours and right --------------------------------------------------------------------------

// An example: the point 30% across and 10% up, and the answer of somebody who counts from the
// middle of the plane. That answer is wrong by half a width and half a height.
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
    plot_text(plot, "why", example ? "Is (0, 0) the corner or the center?" : "");
    beside_vectors(plot, c.origin, right, c.origin, yours);
    beside_words(plot, (BesideWords){vec3_shown(right).s, vec3_shown(yours).s,
                                     beside_off(c, yours - right).s, "dashed"});
    plot_look(plot, c.right, c.up, c.forward, 28, 16);
    plot_handle_vector(plot, "your vector", "yours", c.origin, yours, c.right, c.up);
    plot_name(plot, (Label){"$p$", "blue", .block = "eye"});
    // On two lines, if one is too long.
    Text off = beside_off(c, yours - right);
    char *steps = plot_width(plot, "{off}") > 640 ? strstr(off.s, "= ") : NULL;
    plot_label(plot, "off_steps", steps != NULL ? steps : "");
    if (steps != NULL)
        steps[-1] = '\0';
    plot_label(plot, "off_vector", off.s);
    // A wrong answer of the user takes the place of the example.
    bool is_wrong = plot_says_yours(plot, "answer");
    plot_say(
        plot, 0, 1, {"right: {answer}", "blue", .step = 1},
        {is_wrong ? "yours: {your_answer}" : "yours: {yours}", "ink", .step = 2},
        {is_wrong ? "" : "{off_vector}", "grey", .step = 3},
        {!is_wrong && steps != NULL ? "{off_steps}" : "", "grey", .step = 3},
        {!is_wrong && example ? "Is (0, 0) the corner or the center?" : "", "grey", .step = 3});
}

const Figure corner_figures[] = {
    {"camera-frame", camera_frame},       {"corner-vectors", corner_vectors},
    {"point-30-10", point_30_10},         {"double-dwh", double_dwh},
    {"yours-and-right", yours_and_right}, {0}};
