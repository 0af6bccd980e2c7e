// figures.c - the numbers that the figures of chapter 03 show.
//
// Blocks in x and y are in screen coordinates: y counts down. The layouts draw it that way.
#include "chapters/03-screen/figures/figures.h"

#include "exercises/03-screen.h"

static void screen_data(Plot *plot, Resolution screen)
{
    plot_pair(plot, "screen", "W", screen.width, "H", screen.height);
}

static void screen_to_unit(Plot *plot, void *given)
{
    const Spot *spot = given;
    Normalized place = screen_to_normalized(spot->point, spot->screen);
    screen_data(plot, spot->screen);
    plot_pair(plot, "point", "x", spot->point.x, "y", spot->point.y);
    plot_pair(plot, "place", "s", place.s, "t", place.t);
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
    plot_row(plot, 2, (const double[]){x0, y0});
    plot_row(plot, 2, (const double[]){x1, y1});
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
    plot_row(plot, 2, (const double[]){NAN, NAN});
}

static void counted(Plot *plot, const char *name, Shown shown)
{
    plot_block(plot, name, "the number of each, and also the coordinate where it begins");
    for (int i = shown.first; i < shown.end; i++)
        plot_row(plot, 1, (const double[]){i});
    plot_block_end(plot);
}

static void centers(Plot *plot, Shown columns, Shown rows)
{
    plot_block(plot, "centers", "x y of the point that stands for each pixel");
    for (int row = rows.first; row < rows.end; row++)
        for (int column = columns.first; column < columns.end; column++) {
            ScreenPoint center = pixel_center((Pixel){column, row});
            plot_row(plot, 2, (const double[]){center.x, center.y});
        }
    plot_block_end(plot);
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

    screen_data(plot, screen);
    plot_pair(plot, "pixel", "column", pixel.column, "row", pixel.row);
    plot_pair(plot, "center", "x", center.x, "y", center.y);
    plot_pair(plot, "place", "s", place.s, "t", place.t);
    plot_block(plot, "sample", "x y of the centre, s t of the same");
    plot_row(plot, 4, (const double[]){center.x, center.y, place.s, place.t});
    plot_block_end(plot);
    plot_number(plot, "whole", whole);
    plot_pair(plot, "begin", "x", begin_of(columns), "y", begin_of(rows));
    plot_pair(plot, "end", "x", end_of(columns), "y", end_of(rows));
    plot_block(plot, "grid", "x y of the two ends of a line between pixels");
    lines(plot, columns, rows, false);
    plot_block_end(plot);
    plot_block(plot, "edges", "x y of the two ends of an edge of the screen");
    lines(plot, columns, rows, true);
    plot_block_end(plot);
    counted(plot, "columns", columns);
    counted(plot, "rows", rows);
    centers(plot, columns, rows);
}

static const Figure figures[] = {
    {"screen-to-unit", screen_to_unit}, {"pixel-grid", pixel_grid}, {0}};

int screen_figure(const char *program, FigureCommand command, const Spot *spot)
{
    Spot copy = *spot;
    return plot_figure(program, "chapters/03-screen", figures, command, &copy);
}
