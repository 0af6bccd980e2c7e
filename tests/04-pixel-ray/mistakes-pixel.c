// mistakes-pixel.c - wrong rays of a pixel: the mistake is on the screen, between pixel and point.
#include "exercises/04-pixel-ray.h"

#include "exercises/01-corners.h"
#include "exercises/03-screen.h"
#include "tests/judge/mistake.h"

// The right way on, from a point of the screen.
static vec3 towards(Camera camera, Resolution screen, ScreenPoint point)
{
    Normalized place = screen_to_normalized(point, screen);
    return image_plane_vector(camera, place.s, place.t);
}

static Ray corner_of_the_pixel(Camera camera, Resolution screen, Pixel pixel)
{
    ScreenPoint point = {pixel.column, pixel.row};
    return (Ray){camera.origin, towards(camera, screen, point)};
}

static Ray half_a_pixel_twice(Camera camera, Resolution screen, Pixel pixel)
{
    ScreenPoint point = {pixel.column + 1, pixel.row + 1};
    return (Ray){camera.origin, towards(camera, screen, point)};
}

static Ray half_a_pixel_back(Camera camera, Resolution screen, Pixel pixel)
{
    ScreenPoint point = {pixel.column - 0.5, pixel.row - 0.5};
    return (Ray){camera.origin, towards(camera, screen, point)};
}

static Ray center_of_the_pixel_above(Camera camera, Resolution screen, Pixel pixel)
{
    ScreenPoint point = {pixel.column + 0.5, pixel.row - 0.5};
    return (Ray){camera.origin, towards(camera, screen, point)};
}

static Ray only_the_column(Camera camera, Resolution screen, Pixel pixel)
{
    ScreenPoint point = {pixel.column + 0.5, pixel.row};
    return (Ray){camera.origin, towards(camera, screen, point)};
}

static Ray only_the_row(Camera camera, Resolution screen, Pixel pixel)
{
    ScreenPoint point = {pixel.column, pixel.row + 0.5};
    return (Ray){camera.origin, towards(camera, screen, point)};
}

static Ray last_row_turned_over(Camera camera, Resolution screen, Pixel pixel)
{
    ScreenPoint point = {pixel.column, pixel.row + 1};
    return (Ray){camera.origin, towards(camera, screen, point)};
}

static Ray row_and_column_swapped(Camera camera, Resolution screen, Pixel pixel)
{
    ScreenPoint point = {pixel.row + 0.5, pixel.column + 0.5};
    return (Ray){camera.origin, towards(camera, screen, point)};
}

static Ray sizes_swapped(Camera camera, Resolution screen, Pixel pixel)
{
    Resolution swapped = {screen.height, screen.width};
    return (Ray){camera.origin, towards(camera, swapped, pixel_center(pixel))};
}

static Ray width_for_both(Camera camera, Resolution screen, Pixel pixel)
{
    Resolution square = {screen.width, screen.width};
    return (Ray){camera.origin, towards(camera, square, pixel_center(pixel))};
}

static Ray height_for_both(Camera camera, Resolution screen, Pixel pixel)
{
    Resolution square = {screen.height, screen.height};
    return (Ray){camera.origin, towards(camera, square, pixel_center(pixel))};
}

static Ray one_pixel_less(Camera camera, Resolution screen, Pixel pixel)
{
    double s = (double)pixel.column / (screen.width - 1);
    double t = 1 - (double)pixel.row / (screen.height - 1);
    return (Ray){camera.origin, image_plane_vector(camera, s, t)};
}

static Ray one_pixel_less_for_centers(Camera camera, Resolution screen, Pixel pixel)
{
    ScreenPoint point = pixel_center(pixel);
    return (Ray){camera.origin, image_plane_vector(camera, point.x / (screen.width - 1),
                                                   1 - point.y / (screen.height - 1))};
}

static Ray not_normalized(Camera camera, Resolution screen, Pixel pixel)
{
    (void)screen;
    ScreenPoint point = pixel_center(pixel);
    return (Ray){camera.origin, image_plane_vector(camera, point.x, point.y)};
}

static Ray row_and_column_as_they_are(Camera camera, Resolution screen, Pixel pixel)
{
    (void)screen;
    return (Ray){camera.origin, image_plane_vector(camera, pixel.column, pixel.row)};
}

static Ray whole_numbers_divided(Camera camera, Resolution screen, Pixel pixel)
{
    int s = pixel.column / screen.width, t = 1 - pixel.row / screen.height;
    return (Ray){camera.origin, image_plane_vector(camera, s, t)};
}

static Ray whole_numbers_not_turned_over(Camera camera, Resolution screen, Pixel pixel)
{
    int s = pixel.column / screen.width, t = pixel.row / screen.height;
    return (Ray){camera.origin, image_plane_vector(camera, s, t)};
}

static Ray whole_numbers_turned_over_in_pixels(Camera camera, Resolution screen, Pixel pixel)
{
    int s = pixel.column / screen.width, t = (screen.height - pixel.row) / screen.height;
    return (Ray){camera.origin, image_plane_vector(camera, s, t)};
}

static Ray not_turned_over(Camera camera, Resolution screen, Pixel pixel)
{
    ScreenPoint point = pixel_center(pixel);
    return (Ray){camera.origin,
                 image_plane_vector(camera, point.x / screen.width, point.y / screen.height)};
}

static Ray corner_not_turned_over(Camera camera, Resolution screen, Pixel pixel)
{
    double s = (double)pixel.column / screen.width;
    double t = (double)pixel.row / screen.height;
    return (Ray){camera.origin, image_plane_vector(camera, s, t)};
}

const Mistake pixel_mistakes[] = {
    MISTAKE("P1", pixel_ray, corner_of_the_pixel, "through (column, row)",
            "this is the pixel's corner, which it shares with three other pixels. The ray must go "
            "through the pixel's centre.",
            "half a pixel off"),
    MISTAKE("P2", pixel_ray, half_a_pixel_twice, "through (column + 1, row + 1)",
            "half a pixel is added twice, which leads to the opposite corner. One of your "
            "functions adds it already.",
            "half a pixel off the other way"),
    MISTAKE("P-back", pixel_ray, half_a_pixel_back, "through (column - 1/2, row - 1/2)",
            "a pixel extends right and down from its corner. This is the centre of another pixel.",
            "a whole pixel off, to the left and upward"),
    MISTAKE("P-up", pixel_ray, center_of_the_pixel_above, "through (column + 1/2, row - 1/2)",
            "rows are counted downward. This is the centre of the pixel above.",
            "a pixel too high"),
    MISTAKE(
        "P-column", pixel_ray, only_the_column, "through (column + 1/2, row)",
        "this is the middle of the pixel's upper edge. A row also has a height: add half of it.",
        "half a pixel off, upward"),
    MISTAKE(
        "P-row", pixel_ray, only_the_row, "through (column, row + 1/2)",
        "this is the middle of the pixel's left side. A column also has a width: add half of it.",
        "half a pixel off, to the left"),
    MISTAKE("P-last", pixel_ray, last_row_turned_over, "through (column, row + 1)",
            "t = (H - 1 - row)/H gives this: the pixel's lower left corner and not its centre.",
            "half a pixel off, to the left and downward"),
    MISTAKE("P4", pixel_ray, row_and_column_swapped, "row across, column down",
            "columns are counted across and rows down. Here they are swapped.",
            "mirrored in the diagonal: rows become columns"),
    MISTAKE("P-sizes", pixel_ray, sizes_swapped, "x/H and y/W",
            "the screen is W wide and H high; x runs across and y down.",
            "right on a square screen; if not square, squashed and cut off"),
    MISTAKE("P-width", pixel_ray, width_for_both, "x/W and y/W",
            "W is used for both. From the top of the screen to the bottom it is H pixels.",
            "right on a square screen; if not square, out of shape and shifted"),
    MISTAKE("P-height", pixel_ray, height_for_both, "x/H and y/H",
            "H is used for both. From the left of the screen to the right it is W pixels.",
            "right on a square screen; if not square, out of shape and shifted"),
    MISTAKE("P-less", pixel_ray, one_pixel_less, "column/(W - 1) and row/(H - 1)",
            "this puts the outermost centres onto the edges of the plane. They lie half a pixel "
            "inside.",
            "everything slightly too small; on a single pixel, nothing"),
    MISTAKE("P-less-half", pixel_ray, one_pixel_less_for_centers, "x/(W - 1) and y/(H - 1)",
            "four pixels have five edges, and from the first edge to the last it is four pixels, "
            "not three.",
            "everything slightly too small; on a single pixel, nothing"),
    MISTAKE("P-pixels", pixel_ray, not_normalized, "x and y for s and t",
            "these are pixels; the camera needs shares of the screen, counted from the lower left.",
            "one flat colour: after the first pixel the rays leave the view"),
    MISTAKE(
        "P-raw", pixel_ray, row_and_column_as_they_are, "s = column, t = row",
        "these count pixels; the camera needs shares of the screen, counted from the lower left.",
        "one flat colour: after the first pixel the rays leave the view"),
    MISTAKE("P-whole", pixel_ray, whole_numbers_divided, "column/W and row/H in integers",
            "in C, 300 / 640 is an integer division: its result is 0, so every ray goes to the "
            "same corner.",
            "one flat colour"),
    MISTAKE("P-whole-down", pixel_ray, whole_numbers_not_turned_over,
            "s = column/W, t = row/H in integers",
            "in C, 300 / 640 is an integer division: its result is 0, so every ray goes to the "
            "same corner. And rows are counted downward, t upward.",
            "one flat colour"),
    MISTAKE("P-whole-turned", pixel_ray, whole_numbers_turned_over_in_pixels,
            "s = column/W, t = (H - row)/H in integers",
            "in C, 300 / 640 is an integer division: its result is 0, so all rays except those of "
            "row 0 go to the same corner.",
            "one flat colour, another in the first row"),
    MISTAKE("P-down", pixel_ray, not_turned_over, "t = y/H",
            "rows are counted downward and t upward. This is the share of the way down.",
            "upside down"),
    MISTAKE(
        "P-down-corner", pixel_ray, corner_not_turned_over, "s = column/W, t = row/H",
        "rows are counted downward and t upward; and this is the pixel's corner, not its centre.",
        "upside down, and half a pixel off"),
    {0},
};
