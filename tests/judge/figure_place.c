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

// $NAME_frame: the rectangle; NAME_low_x ... the range that must be visible; NAME_down: whether y
// points down.
static void write_panel(Plot *plot, const char *name, Panel panel, double seen[][2], int count)
{
    char key[40];
    Range x = {panel.left, panel.left + panel.width};
    Range y = {panel.bottom, panel.bottom + panel.height};
    snprintf(key, sizeof key, "%s_frame", name);
    plot_block(plot, key, "x y of the corners");
    static const int corners[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    for (int i = 0; i < 5; i++)
        plot_row(plot, 2,
                 (const double[]){panel.left + corners[i][0] * panel.width,
                                  panel.bottom + corners[i][1] * panel.height});
    plot_block_end(plot);
    for (int i = 0; i < count; i++) {
        range_add(&x, seen[i][0]);
        range_add(&y, seen[i][1]);
    }
    const double limits[] = {x.low, x.high, panel.is_screen ? -y.high : y.low,
                             panel.is_screen ? -y.low : y.high};
    static const char *const names[] = {"low_x", "high_x", "low_y", "high_y"};
    for (int i = 0; i < 4; i++) {
        snprintf(key, sizeof key, "%s_%s", name, names[i]);
        plot_number(plot, key, limits[i]);
    }
    snprintf(key, sizeof key, "%s_down", name);
    plot_number(plot, key, panel.is_screen);
    snprintf(key, sizeof key, "%s_origin", name);
    plot_label(plot, key, pair_text(panel.left, panel.bottom).s);
    snprintf(key, sizeof key, "%s_corner", name);
    plot_label(plot, key, pair_text(panel.left + panel.width, panel.bottom + panel.height).s);
}

static void write_dot(Plot *plot, const char *name, const double *place)
{
    plot_block(plot, name, "x y");
    plot_row(plot, 2, place);
    plot_block_end(plot);
}

void write_place(Plot *plot, void *given)
{
    const Wrong *wrong = given;
    double answers[2][2] = {{places.right[0], places.right[1]}, {places.yours[0], places.yours[1]}};
    Text off;
    plot_text(plot, "asked", wrong->function);
    plot_text(plot, "why", wrong->why);
    plot_number(plot, "has_given", places.has_given);
    write_panel(plot, "from", places.from, &places.given, places.has_given);
    write_dot(plot, "given", places.given);
    plot_label(plot, "given", pair_text(places.given[0], places.given[1]).s);
    write_panel(plot, "into", places.into, answers, 2);
    write_dot(plot, "answer", places.right);
    write_dot(plot, "yours", places.yours);
    snprintf(off.s, sizeof off.s, "off by %.100s",
             pair_text(places.yours[0] - places.right[0], places.yours[1] - places.right[1]).s);
    beside_words(plot, pair_text(places.right[0], places.right[1]).s,
                 pair_text(places.yours[0], places.yours[1]).s, off.s);
}
