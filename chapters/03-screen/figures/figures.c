// figures.c - the numbers that the figures of chapter 03 show.
//
// Blocks in x and y are in screen coordinates: y counts down. The layouts draw it that way.
#include "chapters/03-screen/figures/figures.h"

#include "chapters/shared/digits.h"
#include "exercises/03-screen.h"

#include <stdio.h>

static void screen_data(Plot *plot, Resolution screen)
{
    plot_pair(plot, "screen", "W", screen.width, "H", screen.height);
}

// A panel: a rectangle from 0, 0 to a corner, its two axes beside it, and a point of it with the
// strokes that lead there. Axes and strokes are a little outside of the rectangle.
typedef struct {
    const char *outline, *origin, *first, *second; // names of blocks
    double x, y;                                   // the corner
    double at_x, at_y, from_y;                     // the point, and where its second stroke begins
    bool is_below;                                 // the first axis is below, else above
} PointPanel;

static vec3 flat(double x, double y)
{
    return vec3_of(x, y, 0);
}

static void point_panel(Plot *plot, PointPanel p)
{
    double aside = 0.07 * fmax(fabs(p.x), fabs(p.y));
    double left = fmin(0, p.at_x) - aside, low = fmin(fmin(0, p.y), p.at_y);
    double level = p.is_below ? low - aside : fmax(0, p.at_y) + aside;
    const vec3 corners[] = {flat(0, 0), flat(p.x, 0), flat(p.x, p.y), flat(0, p.y), flat(0, 0)};
    plot_block(plot, p.outline, "x y z of the corners");
    for (int i = 0; i < 5; i++)
        plot_row_point(plot, corners[i]);
    plot_point(plot, p.origin, flat(0, 0));
    plot_seen_vector(plot, text_of("%s_axis", p.first).s, flat(0, level), flat(p.x, 0));
    plot_seen_vector(plot, text_of("%s_axis", p.second).s, flat(left, 0), flat(0, p.y));
    plot_fit(plot, flat(p.at_x, p.at_y), 0);
    plot_vector(plot, p.first, flat(0, p.at_y), flat(p.at_x, 0));
    plot_vector(plot, p.second, flat(p.at_x, p.from_y), flat(0, p.at_y - p.from_y));
    plot_line(plot, flat(p.at_x, p.at_y), flat(p.at_x, p.at_y), 0, 0);
}

static void screen_to_unit_words(Plot *plot)
{
    // The arrow between them, which the layout draws.
    plot_keep_clear(plot, (Room){0.455, 0.615, 0.42, 0.44}, (Room){0.43, 0.64, 0.42, 0.44});
    plot_pin(plot, 0.535, 0.57, {"$s = x/${screen_W}", "orange", .step = 3});
    plot_pin(plot, 0.535, 0.43, {"$t = 1 − y/${screen_H}", "green", .step = 3});
    const char *from_top =
        plot_shown(plot, "point_y") < 0 ? "1 − ({point_y})/{screen_H}" : "1 − {point_y}/{screen_H}";
    bool is_wrong = plot_says_yours(plot, "place");
    plot_pin(plot, 0.5, is_wrong ? 0.14 : 0.1,
             {"$s =$ {point_x}/{screen_W} = {place_s}", "orange", .step = 5},
             {text_of("$t =$ %s = {place_t}", from_top).s, "green", .step = 5},
             {is_wrong ? "yours: {your_place}" : "", "ink", .step = 5});
}

static void screen_to_unit(Plot *plot, void *given)
{
    const Spot *spot = given;
    Normalized place = screen_to_normalized(spot->point, spot->screen);
    screen_data(plot, spot->screen);
    plot_pair(plot, "point", "x", spot->point.x, "y", spot->point.y);
    plot_pair_to(plot, "place", "s", place.s, "t", place.t, place_digits(spot->screen));
    plot_look_flat(plot);
    plot_room(plot, (Room){0.03, 0.41, 0.24, 0.84}, (Room){0.02, 0.40, 0.24, 0.84});
    point_panel(plot, (PointPanel){"screen_outline", "screen_origin", "x", "y", spot->screen.width,
                                   -spot->screen.height, spot->point.x, -spot->point.y, 0, false});
    plot_names(plot, {"origin", "ink", .block = "screen_origin"},
               {"$x$", "orange", .block = "x_axis", .part = ANYWHERE},
               {"{screen_W}", "orange", .block = "x_axis", .part = 1},
               {"$y$", "green", .block = "y_axis", .part = ANYWHERE},
               {"{screen_H}", "green", .block = "y_axis", .part = 1},
               {"{point}", "blue", .place = flat(spot->point.x, -spot->point.y)},
               {"{point_x}", "orange", .block = "x", .part = ANYWHERE},
               {"{point_y}", "green", .block = "y", .part = ANYWHERE});
    plot_handle(plot, (Handle){.words = "the point on the screen",
                               .place = flat(spot->point.x, -spot->point.y),
                               .option = {"point"},
                               .count = 2,
                               .value = flat(spot->point.x, spot->point.y),
                               .along = {flat(1, 0), flat(0, -1)},
                               .most = {spot->screen.width, spot->screen.height}});
    plot_panel(plot, 2);
    plot_room(plot, (Room){0.66, 0.98, 0.24, 0.84}, (Room){0.69, 0.98, 0.24, 0.84});
    double s = plot_shown(plot, "place_s"), t = plot_shown(plot, "place_t");
    point_panel(plot, (PointPanel){"square", "square_origin", "s", "t", 1, 1, s, t, 0, true});
    plot_vector(plot, "from_top", flat(s, 1), flat(0, t - 1));
    plot_names(plot, {"origin", "ink", .step = 2, .block = "square_origin"},
               {"$s$", "orange", .step = 2, .block = "s_axis", .part = ANYWHERE},
               {"1", "orange", .step = 2, .block = "s_axis", .part = 1},
               {"$t$", "green", .step = 2, .block = "t_axis", .part = ANYWHERE},
               {"1", "green", .step = 2, .block = "t_axis", .part = 1},
               {"$(s, t)$", "blue", .step = 4, .place = flat(s, t)});
    plot_panel(plot, 1);
    screen_to_unit_words(plot);
}

// ---- pixel-grid ---------------------------------------------------------------------------------

// Pixels large enough to be seen one by one: all of a small screen, or those around one.
typedef struct {
    int first, end, all; // first <= shown < end, of all columns or rows
} Shown;

static Shown shown_around(int at, int all, bool whole, int most)
{
    int count = whole || all < most ? all : most;
    int first = at - (count - 1) / 2;
    first = first > all - count ? all - count : first;
    first = first < 0 ? 0 : first;
    return (Shown){first, first + count, all};
}

// If the screen goes on beyond the part that is shown, its lines go on a little.
static double begin_of(Shown shown)
{
    return shown.first > 0 ? shown.first - 0.4 : 0;
}

static double end_of(Shown shown)
{
    return shown.end < shown.all ? shown.end + 0.4 : shown.all;
}

static void line(Plot *plot, double x0, double y0, double x1, double y1)
{
    plot_row(plot, x0, y0);
    plot_row(plot, x1, y1);
    plot_gap(plot);
}

// The lines between pixels, or, if outer, the edges of the screen, as far as they are shown.
static void lines(Plot *plot, Shown columns, Shown rows, bool outer)
{
    for (int i = columns.first; i <= columns.end; i++)
        if ((i == 0 || i == columns.all) == outer)
            line(plot, i, begin_of(rows), i, end_of(rows));
    for (int i = rows.first; i <= rows.end; i++)
        if ((i == 0 || i == rows.all) == outer)
            line(plot, begin_of(columns), i, end_of(columns), i);
    // A screen of one pixel has no line inside, but a block must not be empty.
    plot_row(plot, NAN, NAN);
}

static void counted(Plot *plot, const char *name, Shown shown)
{
    plot_block(plot, name, "the number of each, and also the coordinate where it begins");
    for (int i = shown.first; i < shown.end; i++)
        plot_row(plot, i);
}

static void centers(Plot *plot, Shown columns, Shown rows)
{
    plot_block(plot, "centers", "x y of the point that stands for each pixel");
    for (int row = rows.first; row < rows.end; row++)
        for (int column = columns.first; column < columns.end; column++) {
            ScreenPoint center = pixel_center((Pixel){column, row});
            plot_row(plot, center.x, center.y);
        }
}

static void pixel_grid(Plot *plot, void *given)
{
    enum { WHOLE_WIDTH = 12, WHOLE_HEIGHT = 9, PART_WIDTH = 8, PART_HEIGHT = 6 };
    const Spot *spot = given;
    Resolution screen = spot->screen;
    Pixel pixel = spot->pixel;
    bool whole = screen.width <= WHOLE_WIDTH && screen.height <= WHOLE_HEIGHT;
    Shown columns = shown_around(pixel.column, screen.width, whole, PART_WIDTH);
    Shown rows = shown_around(pixel.row, screen.height, whole, PART_HEIGHT);
    ScreenPoint center = pixel_center(pixel);
    Normalized place = screen_to_normalized(center, screen);

    plot_look_flat(plot);
    plot_fill_room(plot);
    plot_room(plot, (Room){0.075, 0.505, 0.16, 0.73}, (Room){0.09, 0.85, 0.42, 0.73});
    plot_fit(plot, flat(begin_of(columns), -begin_of(rows)), 0);
    plot_fit(plot, flat(end_of(columns), -end_of(rows)), 0);
    screen_data(plot, screen);
    plot_pair(plot, "pixel", "column", pixel.column, "row", pixel.row);
    plot_pair(plot, "center", "x", center.x, "y", center.y);
    plot_pair_to(plot, "place", "s", place.s, "t", place.t, place_digits(screen));
    plot_block(plot, "sample", "x y of the center, s t of the same");
    plot_row(plot, center.x, center.y, place.s, place.t);
    plot_number(plot, "whole", whole);
    plot_pair(plot, "begin", "x", begin_of(columns), "y", begin_of(rows));
    plot_pair(plot, "end", "x", end_of(columns), "y", end_of(rows));
    plot_block(plot, "grid", "x y of the two ends of a line between pixels");
    lines(plot, columns, rows, false);
    plot_block(plot, "edges", "x y of the two ends of an edge of the screen");
    lines(plot, columns, rows, true);
    counted(plot, "columns", columns);
    counted(plot, "rows", rows);
    centers(plot, columns, rows);
    plot_handle_pixel(plot, flat(center.x, -center.y), pixel, screen, flat(1, 0), flat(0, -1));
}

const Figure screen_figures[] = {
    {"screen-to-unit", screen_to_unit}, {"pixel-grid", pixel_grid}, {0}};
