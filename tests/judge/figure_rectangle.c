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
    plot_block(plot, name, "x y of the corners; y counts up from the top, so it is negative");
    const double corners[5][2] = {{box.left, -box.top},
                                  {box.right, -box.top},
                                  {box.right, -box.bottom},
                                  {box.left, -box.bottom},
                                  {box.left, -box.top}};
    for (int i = 0; i < 5; i++)
        plot_row(plot, 2, corners[i]);
    plot_block_end(plot);
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
    plot_block(plot, "outline", "x y of the sphere's outline");
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
            plot_row(plot, 2, (const double[]){x, -y});
    }
    if (!seen)
        plot_row(plot, 2, (const double[]){0, 0});
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
    Range x = {0, screen.right}, y = {-screen.bottom, 0};
    range_add(&x, asked.yours.left);
    range_add(&x, asked.yours.right);
    range_add(&y, -asked.yours.top);
    range_add(&y, -asked.yours.bottom);
    plot_text(plot, "asked", wrong->function);
    plot_text(plot, "why", wrong->why);
    plot_number(plot, "low_x", x.low);
    plot_number(plot, "high_x", x.high);
    plot_number(plot, "low_y", y.low);
    plot_number(plot, "high_y", y.high);
    write_rectangle_block(plot, "frame", screen);
    plot_label(plot, "origin", pair_text(0, 0).s);
    plot_label(plot, "corner", pair_text(screen.right, screen.bottom).s);
    write_outline(plot);
    write_rectangle_block(plot, "answer", asked.right);
    write_rectangle_block(plot, "yours", asked.yours);
    beside_words(plot, words_of(asked.right).s, words_of(asked.yours).s, "");
}
