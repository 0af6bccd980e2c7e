// mistakes-axes.c - wrong rays of a pixel: slips on one axis only, on screens of one shape
// only, and rays in fewer digits.
#include "exercises/04-pixel-ray.h"

#include "exercises/01-corners.h"
#include "exercises/03-screen.h"
#include "tests/judge/mistake.h"

static Ray through(Camera camera, double s, double t)
{
    return (Ray){camera.origin, image_plane_vector(camera, s, t)};
}

static Ray one_column_less(Camera camera, Resolution screen, Pixel pixel)
{
    double s = (double)pixel.column / (screen.width - 1);
    return through(camera, s, 1 - (pixel.row + 0.5) / screen.height);
}

static Ray one_row_less(Camera camera, Resolution screen, Pixel pixel)
{
    double t = 1 - (double)pixel.row / (screen.height - 1);
    return through(camera, (pixel.column + 0.5) / screen.width, t);
}

static Ray s_from_minus_1(Camera camera, Resolution screen, Pixel pixel)
{
    Normalized place = screen_to_normalized(pixel_center(pixel), screen);
    return through(camera, 2 * place.s - 1, place.t);
}

static Ray t_from_minus_1(Camera camera, Resolution screen, Pixel pixel)
{
    Normalized place = screen_to_normalized(pixel_center(pixel), screen);
    return through(camera, place.s, 2 * place.t - 1);
}

static Ray whole_columns_divided(Camera camera, Resolution screen, Pixel pixel)
{
    int s = pixel.column / screen.width;
    return through(camera, s, 1 - (pixel.row + 0.5) / screen.height);
}

static Ray whole_rows_divided(Camera camera, Resolution screen, Pixel pixel)
{
    int t = 1 - pixel.row / screen.height;
    return through(camera, (pixel.column + 0.5) / screen.width, t);
}

static Ray straight_ahead_where_a_side_is_1(Camera camera, Resolution screen, Pixel pixel)
{
    bool thin = screen.width == 1 || screen.height == 1;
    return thin ? through(camera, 0.5, 0.5) : pixel_ray(camera, screen, pixel);
}

static Ray larger_side_for_both(Camera camera, Resolution screen, Pixel pixel)
{
    int side = screen.width > screen.height ? screen.width : screen.height;
    return pixel_ray(camera, (Resolution){side, side}, pixel);
}

static Ray smaller_side_for_both(Camera camera, Resolution screen, Pixel pixel)
{
    int side = screen.width < screen.height ? screen.width : screen.height;
    return pixel_ray(camera, (Resolution){side, side}, pixel);
}

static Ray in_float(Camera camera, Resolution screen, Pixel pixel)
{
    Ray ray = pixel_ray(camera, screen, pixel);
    for (int i = 0; i < 3; i++) {
        ray.origin[i] = (float)ray.origin[i];
        ray.direction[i] = (float)ray.direction[i];
    }
    return ray;
}

const Mistake pixel_axis_mistakes[] = {
    MISTAKE("P-less-x", pixel_ray, one_column_less, "column/(W - 1)",
            "this puts the outermost centres onto the left and right edges of the plane. They lie "
            "half a pixel inside.",
            "everything slightly too narrow; in a single column, nothing"),
    MISTAKE("P-less-y", pixel_ray, one_row_less, "row/(H - 1)",
            "this puts the outermost centres onto the top and bottom edges of the plane. They lie "
            "half a pixel inside.",
            "everything slightly too low; in a single row, nothing"),
    MISTAKE("P-wide-x", pixel_ray, s_from_minus_1, "s from -1 to 1",
            "s goes from -1 to 1, and t from 0 to 1. Both must go from 0 to 1.",
            "everything at half its width, and shifted"),
    MISTAKE("P-wide-y", pixel_ray, t_from_minus_1, "t from -1 to 1",
            "t goes from -1 to 1, and s from 0 to 1. Both must go from 0 to 1.",
            "everything at half its height, and shifted"),
    MISTAKE("P-whole-x", pixel_ray, whole_columns_divided, "column/W in integers",
            "in C, 300 / 640 is an integer division: its result is 0, so the rays of all columns "
            "go to the left edge.",
            "stripes from left to right: all columns are alike"),
    MISTAKE("P-whole-y", pixel_ray, whole_rows_divided, "row/H in integers",
            "in C, 400 / 480 is an integer division: its result is 0, so the rays of all rows go "
            "to the top edge.",
            "stripes from top to bottom: all rows are alike"),
    MISTAKE("P-thin", pixel_ray, straight_ahead_where_a_side_is_1, "straight ahead if W or H is 1",
            "a single column still has as many rows as the screen is high, and each has its own "
            "place. No screen needs a special case.",
            "no visible difference, except in pictures of one column or row"),
    MISTAKE("P-larger", pixel_ray, larger_side_for_both, "the larger of W and H for both",
            "x is a share of W and y a share of H, whichever is larger.",
            "right on a square screen; if not square, out of shape and shifted"),
    MISTAKE("P-smaller", pixel_ray, smaller_side_for_both, "the smaller of W and H for both",
            "x is a share of W and y a share of H, whichever is larger.",
            "right on a square screen; if not square, out of shape and shifted"),
    MISTAKE("P-float", pixel_ray, in_float, "in float",
            "a float has 7 digits, and the ray needs 9. Use double.",
            "no visible difference, or ragged edges"),
    {0},
};
