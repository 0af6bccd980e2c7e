// mistakes.c - wrong answers to exercise 03: centres of pixels, and the list of all tables.
#include "exercises/03-screen.h"
#include "tests/judge/mistake.h"

extern const Mistake there_mistakes[], back_mistakes[], screen_axis_mistakes[];

static ScreenPoint corner_of_the_pixel(Pixel pixel)
{
    return (ScreenPoint){pixel.column, pixel.row};
}

static ScreenPoint far_corner_of_the_pixel(Pixel pixel)
{
    return (ScreenPoint){pixel.column + 1, pixel.row + 1};
}

static ScreenPoint row_and_column_swapped(Pixel pixel)
{
    return (ScreenPoint){pixel.row + 0.5, pixel.column + 0.5};
}

static ScreenPoint half_a_pixel_back(Pixel pixel)
{
    return (ScreenPoint){pixel.column - 0.5, pixel.row - 0.5};
}

static ScreenPoint half_a_pixel_up(Pixel pixel)
{
    return (ScreenPoint){pixel.column + 0.5, pixel.row - 0.5};
}

static ScreenPoint half_a_pixel_left(Pixel pixel)
{
    return (ScreenPoint){pixel.column - 0.5, pixel.row + 0.5};
}

static ScreenPoint only_the_column(Pixel pixel)
{
    return (ScreenPoint){pixel.column + 0.5, pixel.row};
}

static ScreenPoint only_the_row(Pixel pixel)
{
    return (ScreenPoint){pixel.column, pixel.row + 0.5};
}

static ScreenPoint average_with_1(Pixel pixel)
{
    return (ScreenPoint){(pixel.column + 1) / 2.0, (pixel.row + 1) / 2.0};
}

static ScreenPoint halved(Pixel pixel)
{
    return (ScreenPoint){0.5 * pixel.column, 0.5 * pixel.row};
}

static ScreenPoint doubled(Pixel pixel)
{
    return (ScreenPoint){2 * pixel.column + 1, 2 * pixel.row + 1};
}

static ScreenPoint column_for_both(Pixel pixel)
{
    return (ScreenPoint){pixel.column + 0.5, pixel.column + 0.5};
}

static ScreenPoint upward(Pixel pixel)
{
    return (ScreenPoint){pixel.column + 0.5, -(pixel.row + 0.5)};
}

static const Mistake center_mistakes[] = {
    MISTAKE("M-corner", pixel_center, corner_of_the_pixel, "(column, row)",
            "this is the pixel's upper left corner, which it shares with three other pixels. If "
            "your code has 1 / 2: in C that is an integer division, and its result is 0.",
            "half a pixel off"),
    MISTAKE("M-far", pixel_center, far_corner_of_the_pixel, "(column + 1, row + 1)",
            "this is the pixel's lower right corner, across the whole square.",
            "half a pixel off the other way"),
    MISTAKE("M-swap", pixel_center, row_and_column_swapped, "(row + 1/2, column + 1/2)",
            "x counts columns, from the left, and y counts rows, from the top.",
            "mirrored in the diagonal: rows become columns"),
    MISTAKE("M-back", pixel_center, half_a_pixel_back, "(column - 1/2, row - 1/2)",
            "the pixel's square starts at (column, row) and extends right and down from there. "
            "This is the centre of another pixel.",
            "a whole pixel off, to the left and upward"),
    MISTAKE("M-up", pixel_center, half_a_pixel_up, "(column + 1/2, row - 1/2)",
            "y grows downward, and the square extends down from its row. This is the centre of the "
            "pixel above.",
            "a pixel too high"),
    MISTAKE("M-left", pixel_center, half_a_pixel_left, "(column - 1/2, row + 1/2)",
            "the square extends to the right from its column. This is the centre of the pixel on "
            "the left.",
            "a pixel too far left"),
    MISTAKE(
        "M-column", pixel_center, only_the_column, "(column + 1/2, row)",
        "this is the middle of the pixel's upper edge. A row also has a height: add half of it.",
        "half a pixel off, upward"),
    MISTAKE(
        "M-row", pixel_center, only_the_row, "(column, row + 1/2)",
        "this is the middle of the pixel's left side. A column also has a width: add half of it.",
        "half a pixel off, to the left"),
    MISTAKE("M-average", pixel_center, average_with_1, "((column + 1)/2, (row + 1)/2)",
            "the column itself is halved. Only the added pixel is halved: column + 1/2.",
            "only the upper left quarter of the view, at twice its size"),
    MISTAKE("M-times", pixel_center, halved, "(column/2, row/2)",
            "this is half way from the corner of the screen to the pixel. The centre is half a "
            "pixel away from the pixel's own corner.",
            "only the upper left quarter of the view, at twice its size"),
    MISTAKE("M-double", pixel_center, doubled, "(2 column + 1, 2 row + 1)",
            "this counts in halves of a pixel. x and y count whole pixels.",
            "everything at half its size, in the upper left quarter"),
    MISTAKE("M-cc", pixel_center, column_for_both, "(column + 1/2, column + 1/2)",
            "how far down a pixel is depends on its row.",
            "stripes from top to bottom: all rows are alike"),
    MISTAKE(
        "M-down", pixel_center, upward, "(column + 1/2, -(row + 1/2))",
        "y grows downward on the screen, as rows do. The axis is reversed later, in the step to t.",
        "upside down, and the view a whole picture too high"),
    {0},
};

static const Mistake *const mistakes[] = {there_mistakes, back_mistakes, center_mistakes,
                                          screen_axis_mistakes, NULL};
OF_STEM(mistakes)
