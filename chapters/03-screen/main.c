// main.c - chapter 03: screen coordinates.
//
// Shows the lecture's point on its screen, the corners and pixel centers, normalized and back. Its
// picture colors each pixel by its own coordinates: red is s, green is t.
#include "chapters/03-screen/figures/figures.h"
#include "chapters/shared/example.h"
#include "common/options.h"
#include "common/picture.h"
#include "common/story.h"
#include "common/text.h"
#include "exercises/03-screen.h"

#include <stdio.h>
#include <string.h>

static void show_point(const char *label, ScreenPoint point, Resolution screen)
{
    Normalized place = screen_to_normalized(point, screen);
    ScreenPoint back = normalized_to_screen(place, screen);
    printf("  %-16s %-18s %-26s %s\n", label, pair_text(point.x, point.y).s,
           pair_text(place.s, place.t).s, pair_text(back.x, back.y).s);
}

static void show_pixel(Pixel pixel, Resolution screen)
{
    char label[32];
    snprintf(label, sizeof label, "pixel %d, %d", pixel.column, pixel.row);
    show_point(label, pixel_center(pixel), screen);
}

static void show_places(double x, double y, Pixel pixel, Resolution screen)
{
    double width = screen.width, height = screen.height;
    printf("03-screen: screen coordinates\n");
    story_heading("A screen of %d x %d pixels", screen.width, screen.height);
    printf("  %-16s %-18s %-26s %s\n", "", "point (x, y)", "normalized (s, t)", "and back");
    show_point("the point", (ScreenPoint){x, y}, screen);
    show_point("upper left", (ScreenPoint){0, 0}, screen);
    show_point("upper right", (ScreenPoint){width, 0}, screen);
    show_point("lower left", (ScreenPoint){0, height}, screen);
    show_point("lower right", (ScreenPoint){width, height}, screen);
    show_point("middle", (ScreenPoint){width / 2, height / 2}, screen);

    story_heading("A pixel is a square, and its center stands for it");
    printf("  %-16s %-18s %-26s %s\n", "", "center (x, y)", "normalized (s, t)", "and back");
    show_pixel(pixel, screen);
    show_pixel((Pixel){0, 0}, screen);
    show_pixel((Pixel){screen.width - 1, screen.height - 1}, screen);
    printf("  No center is on an edge: s and t are always inside (0, 1).\n");
}

static Color color_of_place(Pixel pixel, void *given)
{
    Normalized place = screen_to_normalized(pixel_center(pixel), *(const Resolution *)given);
    return vec3_of(place.s, place.t, 0.25);
}

// Fills in the lecture's numbers for those that are not given. The figure of single pixels needs a
// small screen.
static void complete(Resolution *screen, double point[2], FigureCommand figure)
{
    bool large = figure.name == NULL || strcmp(figure.name, "pixel-grid") != 0 || screen->width > 0;
    if (screen->width == 0)
        *screen = large ? example_screen() : (Resolution){8, 6};
    if (isnan(point[0])) {
        point[0] = large ? example_point().x : 3;
        point[1] = large ? example_point().y : 4;
    }
}

int main(int argc, char **argv)
{
    Resolution screen = {0, 0};
    double point[2] = {NAN, NAN};
    Pixel pixel = {-1, -1};
    FigureCommand figure = {0};
    const char *picture = NULL;
    const Option options[] = {
        {"point", 'p', "X,Y", option_pair, point, "a point on the screen (the lecture's)"},
        {"pixel", 0, "COLUMN,ROW", option_pixel, &pixel, "a pixel (the one the point is in)"},
        {"size", 's', "WIDTHxHEIGHT", option_size, &screen, "size of the screen (the lecture's)"},
        {"picture", 0, "FILE.png", option_string, &picture,
         "draw the screen: red is s, green is t"},
        FIGURE_OPTIONS(figure),
        {0}};
    Usage usage = {"[OPTION]...",
                   "Points on the screen, normalized and back. Without options: the\n"
                   "lecture's point on the lecture's screen."};
    if (options_read(argc, argv, options, usage) != argc)
        options_wrong(argv[0], "expected options only");
    if (picture != NULL && screen.width == 0)
        screen = example_small_screen();
    complete(&screen, point, figure);
    if (pixel.column < 0) // floor; a point on the far edge belongs to the last pixel
        pixel = (Pixel){(int)fmax(0, fmin(floor(point[0]), screen.width - 1)),
                        (int)fmax(0, fmin(floor(point[1]), screen.height - 1))};
    if (pixel.column >= screen.width || pixel.row >= screen.height)
        options_wrong(argv[0], "--pixel: (%d, %d) is not on a screen of %d x %d", pixel.column,
                      pixel.row, screen.width, screen.height);
    if (figure.name != NULL)
        return plot_figure(argv[0], "chapters/03-screen", screen_figures, figure,
                           &(Spot){screen, {point[0], point[1]}, pixel});
    if (picture != NULL)
        return picture_write(picture, screen, color_of_place, &screen);
    show_places(point[0], point[1], pixel, screen);
    return story_end();
}
