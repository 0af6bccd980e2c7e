// figure_place.c - places on the screen and in the unit square: the argument and the result.
#include "tests/judge/figure.h"

#include "common/figure/beside.h"
#include "common/screen.h"
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

static void get_pair(Wire *wire, double pair[2])
{
    WIRE_GET(wire, double, pair[0]);
    WIRE_GET(wire, double, pair[1]);
}

bool read_place(Wrong *wrong)
{
    const Exercise *types = &exercises[wrong->kept->exercise];
    Resolution screen = {1, 1};
    Pixel pixel = {0, 0};
    places.has_given = strcmp(types->arguments, "Pixel") != 0;
    if (places.has_given) {
        get_pair(wrong->question, places.given);
        WIRE_GET(wrong->question, Resolution, screen);
        bool to_screen = strcmp(types->results, "ScreenPoint") == 0;
        places.from = to_screen ? unit_square() : whole_screen(screen);
        places.into = to_screen ? whole_screen(screen) : unit_square();
    } else {
        WIRE_GET(wrong->question, Pixel, pixel);
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
    plot_name(plot, (Label){"right", "blue", .block = "right"});
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
    snprintf(off.s, sizeof off.s, "off by %.100s",
             pair_text(places.yours[0] - places.right[0], places.yours[1] - places.right[1]).s);
    beside_below(plot, wrong->function, wrong->why,
                 (BesideWords){pair_text(places.right[0], places.right[1]).s,
                               pair_text(places.yours[0], places.yours[1]).s, off.s});
}
