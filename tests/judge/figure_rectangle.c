// figure_rectangle.c - a rectangle on the screen: the right one and yours, and the outline of the
// sphere.
#include "tests/judge/figure.h"

#include "common/figure/beside.h"
#include "common/screen.h"
#include "common/sphere.h"

#include <stdio.h>

static struct {
    Camera camera;
    Resolution screen;
    Sphere sphere;
    ScreenRectangle right, yours;
} asked;

bool read_rectangle(Wrong *wrong)
{
    WIRE_GET(wrong->question, Camera, asked.camera);
    WIRE_GET(wrong->question, Resolution, asked.screen);
    WIRE_GET(wrong->question, Sphere, asked.sphere);
    WIRE_GET(wrong->right, ScreenRectangle, asked.right);
    WIRE_GET(wrong->yours, ScreenRectangle, asked.yours);
    Range x = {0, asked.screen.width}, y = {0, asked.screen.height};
    return range_try(&x, asked.yours.left) && range_try(&x, asked.yours.right) &&
           range_try(&y, asked.yours.top) && range_try(&y, asked.yours.bottom);
}

static void write_rectangle_block(Plot *plot, const char *name, ScreenRectangle box)
{
    plot_block(plot, name, "x y z of the corners; y counts up from the top, so it is negative");
    const double corners[5][2] = {{box.left, -box.top},
                                  {box.right, -box.top},
                                  {box.right, -box.bottom},
                                  {box.left, -box.bottom},
                                  {box.left, -box.top}};
    for (int i = 0; i < 5; i++) {
        plot_row_point(plot, vec3_of(corners[i][0], corners[i][1], 0));
        plot_fit(plot, vec3_of(corners[i][0], corners[i][1], 0), 0);
    }
    plot_block_end(plot);
}

// Too small to be seen as a rectangle: the layout marks its place.
static bool is_tiny(ScreenRectangle box)
{
    return fabs(box.right - box.left) < 0.005 * asked.screen.width &&
           fabs(box.bottom - box.top) < 0.005 * asked.screen.height;
}

// The points of the sphere that are on its outline are a circle, nearer to the eye than the centre.
// If the sphere is around the eye, beside it or behind it, there is none.
static void write_outline(Plot *plot)
{
    enum { POINTS = 120 };
    Camera c = asked.camera;
    vec3 to = asked.sphere.center - c.origin, axis = vec3_unit(to);
    double r = asked.sphere.radius, nearer = 1 - r * r / vec3_dot(to, to);
    bool seen = vec3_dot(to, c.forward) > 1.001 * r;
    vec3 other = fabs(vec3_dot(axis, c.up)) < 0.9 ? c.up : c.right;
    vec3 one = vec3_unit(vec3_cross(axis, other)), two = vec3_cross(axis, one);
    plot_block(plot, "outline", "x y z of the sphere's outline");
    for (int i = 0; i <= POINTS; i++) {
        double angle = 2 * PI * i / POINTS;
        vec3 p = nearer * to + r * sqrt(fmax(nearer, 0)) * (cos(angle) * one + sin(angle) * two);
        double d = c.distance / vec3_dot(p, c.forward);
        double x = (0.5 + d * vec3_dot(p, c.right) / c.width) * asked.screen.width;
        double y = (0.5 - d * vec3_dot(p, c.up) / c.height) * asked.screen.height;
        // Beyond the screen there is nothing to see; a point there is moved to its edge.
        x = fmin(fmax(x, 0), asked.screen.width);
        y = fmin(fmax(y, 0), asked.screen.height);
        if (seen)
            plot_row_point(plot, vec3_of(x, -y, 0));
    }
    if (!seen)
        plot_row_point(plot, vec3_of(0, 0, 0));
    plot_block_end(plot);
}

static Text words_of(ScreenRectangle box)
{
    Text text;
    snprintf(text.s, sizeof text.s, "x %.30s to %.30s, y %.30s to %.30s", number_text(box.left).s,
             number_text(box.right).s, number_text(box.top).s, number_text(box.bottom).s);
    return text;
}

void write_rectangle(Plot *plot, void *given)
{
    const Wrong *wrong = given;
    ScreenRectangle screen = {0, asked.screen.width, 0, asked.screen.height};
    plot_look_flat(plot);
    write_rectangle_block(plot, "frame", screen);
    write_outline(plot);
    write_rectangle_block(plot, "answer", asked.right);
    write_rectangle_block(plot, "yours", asked.yours);
    plot_number(plot, "is_tiny", is_tiny(asked.yours));
    plot_name(plot, (Label){pair_text(0, 0).s, "grey", .block = "frame", .row = 0});
    plot_name(plot, (Label){pair_text(screen.right, screen.bottom).s, "grey", .block = "frame",
                            .row = 2});
    plot_name(plot, (Label){"right", "blue", .block = "answer", .row = 1, .part = ANYWHERE});
    plot_name(plot,
              (Label){"yours", "ink", .step = 2, .block = "yours", .row = 3, .part = ANYWHERE});
    beside_below(plot, wrong->function, wrong->why,
                 (BesideWords){words_of(asked.right).s, words_of(asked.yours).s, ""});
}
