// figures.c - the data of the figure of chapter 08: a sphere from above, and the two lines that
// touch it.
//
// On the paper x goes ahead of the eye and y to the left, so the left edge of the screen is above.
#include "chapters/08-fast/rectangles.h"
#include "common/answers.h"
#include "exercises/01-corners.h"
#include "exercises/03-screen.h"
#include "exercises/08-fast.h"

#include <math.h>

enum { CIRCLE = 120, DIGITS = 6 };

typedef struct {
    Camera camera;
    Resolution screen;
    Sphere sphere;
} View;

// One of the two lines. It is seen where it meets the image plane; 'touch' is its point that is
// nearest to the center.
typedef struct {
    vec3 on_plane, touch, end;
    bool is_cut; // at the edge of the screen: then the line need not touch the sphere
} Edge;

static vec3 from_above(const View *view, vec3 from_eye)
{
    return vec3_of(vec3_dot(from_eye, view->camera.forward),
                   -vec3_dot(from_eye, view->camera.right), 0);
}

static vec3 center_of(const View *view)
{
    return from_above(view, view->sphere.center - view->camera.origin);
}

// How far the lines are drawn: past the sphere, and past the image plane.
static double far_away(const View *view)
{
    return 1.15 * fmax(vec3_length(center_of(view)) + view->sphere.radius, view->camera.distance);
}

static Edge edge_at(const View *view, double x)
{
    double s = screen_to_normalized((ScreenPoint){x, 0}, view->screen).s;
    vec3 on_plane = from_above(view, image_plane_vector(view->camera, s, 0.5));
    vec3 along = vec3_unit(on_plane);
    return (Edge){on_plane, vec3_dot(center_of(view), along) * along, far_away(view) * along,
                  x <= 0 || x >= view->screen.width};
}

static void circle(Plot *plot, const View *view)
{
    plot_block(plot, "circle", "x y z, round the sphere from above");
    for (int i = 0; i <= CIRCLE; i++) {
        double angle = 2 * PI * i / CIRCLE;
        plot_row_point(plot,
                       center_of(view) + view->sphere.radius * vec3_of(cos(angle), sin(angle), 0));
    }
    plot_fit(plot, center_of(view), view->sphere.radius);
}

static void plane(Plot *plot, const View *view)
{
    vec3 left = from_above(view, image_plane_vector(view->camera, 0, 0.5));
    vec3 right = from_above(view, image_plane_vector(view->camera, 1, 0.5));
    plot_seen_vector(plot, "plane", left, right - left);
}

// $NAME, the line from the eye; $NAME_mark, where it meets the plane; $NAME_radius, from the center
// to the line.
static void edge(Plot *plot, const View *view, const char *name, double x, Edge one)
{
    plot_number_to(plot, name, x, DIGITS);
    plot_vector(plot, text_of("%s_line", name).s, vec3_of(0, 0, 0), one.end);
    plot_fit(plot, one.end, 0);
    plot_point(plot, text_of("%s_mark", name).s, one.on_plane);
    vec3 center = center_of(view);
    if (one.is_cut)
        plot_undrawn(plot);
    plot_vector(plot, text_of("%s_radius", name).s, center,
                one.is_cut ? vec3_of(NAN, NAN, NAN) : one.touch - center);
}

static void handles(Plot *plot, const View *view)
{
    plot_handle(plot, (Handle){.words = "C, the center of the sphere",
                               .place = center_of(view),
                               .option = {"center"},
                               .count = 3,
                               .value = view->sphere.center,
                               .along = {view->camera.forward, view->camera.right},
                               .way = {vec3_of(1, 0, 0), vec3_of(0, -1, 0)}});
    plot_handle_length(plot, "r, the radius of the sphere", "radius", view->sphere.radius,
                       center_of(view) + vec3_of(view->sphere.radius, 0, 0), vec3_of(1, 0, 0));
}

static void names(Plot *plot, const View *view, bool is_nothing)
{
    vec3 center = center_of(view);
    double small = 0.05 * far_away(view);
    plot_names(plot, {"eye", "grey", .block = "eye"},
               {"image plane", "grey", .block = "plane", .part = ANYWHERE},
               {"$C$", "ink", .block = "center"},
               {fabs(center[0]) > small ? "$z$ = {z}" : "", "grey", .step = 2, .block = "ahead",
                .part = ANYWHERE},
               {fabs(center[1]) > small ? "$x$ = {x}" : "", "grey", .step = 2, .block = "aside",
                .part = ANYWHERE},
               {"$r$ = {r}", "ink", .step = 2, .block = "radius", .part = ANYWHERE},
               {is_nothing ? "" : "left = {left}", "orange", .step = 4, .block = "left_mark"},
               {is_nothing ? "" : "right = {right}", "green", .step = 4, .block = "right_mark"});
    plot_say(plot, 0, 0,
             {is_nothing ? "no rectangle" : "columns {left!} to {right!} of {columns}", "ink",
              .step = 4});
}

static void tangents(Plot *plot, void *given)
{
    const View *view = given;
    vec3 center = center_of(view);
    ScreenRectangle box = sphere_rectangle(view->camera, view->screen, view->sphere);
    plot_look_flat(plot);
    plot_point(plot, "eye", vec3_of(0, 0, 0));
    plot_fit(plot, vec3_of(0, 0, 0), 0);
    plane(plot, view);
    circle(plot, view);
    plot_point(plot, "center", center);
    plot_number_to(plot, "z", center[0], DIGITS);
    plot_number_to(plot, "x", -center[1], DIGITS);
    plot_number_to(plot, "r", view->sphere.radius, DIGITS);
    plot_number(plot, "columns", view->screen.width);
    plot_vector(plot, "ahead", vec3_of(0, 0, 0), vec3_of(center[0], 0, 0));
    plot_vector(plot, "aside", vec3_of(center[0], 0, 0), vec3_of(0, center[1], 0));
    plot_vector(plot, "radius", center, vec3_of(view->sphere.radius, 0, 0));
    Edge left = edge_at(view, box.left), right = edge_at(view, box.right);
    edge(plot, view, "left", box.left, left);
    edge(plot, view, "right", box.right, right);
    bool is_nothing = plot_shown(plot, "left") == 0 && plot_shown(plot, "right") == 0;
    plot_number(plot, "nothing", is_nothing);
    names(plot, view, is_nothing);
    handles(plot, view);
}

static const Figure figures[] = {{"tangents", tangents}, {0}};

int rectangle_figure(const char *program, const RectangleFigure *figure, const Command *command)
{
    static Drawing drawing;
    if (!drawing_prepare(&drawing, program, command, "chapters/06-ray-casting/three-spheres.nff"))
        return EXIT_COULD_NOT;
    View view = {drawing.camera, drawing.size, figure->sphere};
    if (figure->sphere.radius == 0 && drawing.scene.sphere_count > 0)
        view.sphere = drawing.scene.spheres[0];
    scene_free(&drawing.scene);
    return plot_figure(program, "chapters/08-fast", figures, figure->command, &view);
}
