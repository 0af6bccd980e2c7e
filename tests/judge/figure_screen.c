// figure_screen.c - places on the screen and in the unit square, and rectangles on the screen.
#include "common/figure/beside.h"
#include "common/screen.h"
#include "common/sphere.h"
#include "tests/judge/figure.h"
#include "tests/judge/numbers.h"

#include <stdio.h>
#include <string.h>

// A rectangle of this width and height; y or t down, or up.
typedef struct {
    double left, bottom, width, height; // bottom: the lower number
    bool is_screen;
} Panel;

static struct {
    bool has_given;
    double given[2], right[2], yours[2];
    Panel from, into;
} places;

static Panel unit_square(void)
{
    return (Panel){0, 0, 1, 1, false};
}

static Panel whole_screen(Resolution screen)
{
    return (Panel){0, 0, screen.width, screen.height, true};
}

static void get_pair(Numbers *numbers, double pair[2])
{
    NUMBERS_GET(numbers, double, pair[0]);
    NUMBERS_GET(numbers, double, pair[1]);
}

bool read_place(Wrong *wrong)
{
    const Exercise *types = &exercises[wrong->kept->exercise];
    Resolution screen = {1, 1};
    Pixel pixel = {0, 0};
    places.has_given = strcmp(types->arguments, "Pixel") != 0;
    if (places.has_given) {
        get_pair(wrong->question, places.given);
        NUMBERS_GET(wrong->question, Resolution, screen);
        bool to_screen = strcmp(types->results, "ScreenPoint") == 0;
        places.from = to_screen ? unit_square() : whole_screen(screen);
        places.into = to_screen ? whole_screen(screen) : unit_square();
    } else {
        NUMBERS_GET(wrong->question, Pixel, pixel);
        places.from = places.into = (Panel){pixel.column, pixel.row, 1, 1, true};
        memcpy(places.given, (const double[]){pixel.column, pixel.row}, sizeof places.given);
    }
    get_pair(wrong->right, places.right);
    get_pair(wrong->yours, places.yours);
    Range x = {places.into.left, places.into.left + places.into.width};
    Range y = {places.into.bottom, places.into.bottom + places.into.height};
    range_add(&x, places.right[0]);
    range_add(&y, places.right[1]);
    return range_try(&x, places.yours[0]) && range_try(&y, places.yours[1]);
}

// As it is drawn: the screen's y counts down.
static vec3 drawn(Panel panel, const double place[2])
{
    return vec3_of(place[0], panel.is_screen ? -place[1] : place[1], 0);
}

static void write_dot(Plot *plot, const char *name, Panel panel, const double place[2])
{
    plot_point(plot, name, drawn(panel, place));
    plot_label(plot, name, pair_text(place[0], place[1]).s);
    plot_fit(plot, drawn(panel, place), 0);
}

// $NAME: the rectangle, and where it begins and ends in words.
static void write_panel(Plot *plot, const char *name, Panel panel)
{
    const double begin[] = {panel.left, panel.bottom};
    const double end[] = {panel.left + panel.width, panel.bottom + panel.height};
    const vec3 corners[] = {drawn(panel, begin), drawn(panel, (double[]){end[0], begin[1]}),
                            drawn(panel, end), drawn(panel, (double[]){begin[0], end[1]}),
                            drawn(panel, begin)};
    plot_block(plot, name, "x y z of the corners");
    for (int i = 0; i < 5; i++) {
        plot_row_point(plot, corners[i]);
        plot_fit(plot, corners[i], 0);
    }
    plot_block_end(plot);
    plot_name(plot, (Label){pair_text(begin[0], begin[1]).s, "grey", .block = name, .row = 0});
    plot_name(plot, (Label){pair_text(end[0], end[1]).s, "grey", .block = name, .row = 2});
}

void write_place(Plot *plot, void *given)
{
    const Wrong *wrong = given;
    const Room left = {0.03, 0.44, 0.06, 0.84}, right = {0.56, 0.97, 0.06, 0.84};
    Text off;
    plot_look_flat(plot);
    plot_number(plot, "has_given", places.has_given);
    if (places.has_given) {
        plot_room(plot, right, right);
        const Room arrow = {0.46, 0.54, 0.42, 0.48};
        plot_keep_clear(plot, arrow, arrow);
    }
    write_panel(plot, "into", places.into);
    write_dot(plot, "right", places.into, places.right);
    write_dot(plot, "yours", places.into, places.yours);
    plot_name(plot, (Label){"expected", "blue", .block = "right"});
    plot_name(plot, (Label){"yours", "ink", .step = 2, .block = "yours"});
    plot_panel(plot, 2);
    plot_room(plot, left, left);
    if (places.has_given) {
        write_panel(plot, "from", places.from);
        write_dot(plot, "given", places.from, places.given);
        plot_name(plot, (Label){"{given}", "ink", .block = "given"});
    } else {
        plot_point(plot, "from", vec3_of(NAN, NAN, NAN));
        plot_point(plot, "given", vec3_of(NAN, NAN, NAN));
    }
    double by[2]; // rounding is not a difference
    for (int i = 0; i < 2; i++)
        by[i] = same_within(places.yours[i], places.right[i], 1e-12)
                    ? 0
                    : places.yours[i] - places.right[i];
    snprintf(off.s, sizeof off.s, "off by %.100s", pair_text(by[0], by[1]).s);
    beside_below(plot, wrong->function, wrong->why,
                 (BesideWords){pair_text(places.right[0], places.right[1]).s,
                               pair_text(places.yours[0], places.yours[1]).s, off.s, "as a ring"});
}

// ---- a rectangle on the screen: the right one, yours, and the sphere's outline -----------------

static struct {
    Camera camera;
    Resolution screen;
    Sphere sphere;
    ScreenRectangle right, yours;
} asked;

bool read_rectangle(Wrong *wrong)
{
    NUMBERS_GET(wrong->question, Camera, asked.camera);
    NUMBERS_GET(wrong->question, Resolution, asked.screen);
    NUMBERS_GET(wrong->question, Sphere, asked.sphere);
    NUMBERS_GET(wrong->right, ScreenRectangle, asked.right);
    NUMBERS_GET(wrong->yours, ScreenRectangle, asked.yours);
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
    plot_name(plot, (Label){"expected", "blue", .block = "answer", .row = 1, .part = ANYWHERE});
    plot_name(plot,
              (Label){"yours", "ink", .step = 2, .block = "yours", .row = 3, .part = ANYWHERE});
    beside_below(plot, wrong->function, wrong->why,
                 (BesideWords){words_of(asked.right).s, words_of(asked.yours).s, "", "dashed"});
}
