// mistakes-image.c - wrong answers to cast_image_order.
#include "exercises/01-corners.h"
#include "tests/06-ray-casting/mistakes.h"

// ---- slips --------------------------------------------------------------------------------------

static bool in_first_column(Pixel pixel, Resolution size)
{
    (void)size;
    return pixel.column == 0;
}

static bool in_first_row(Pixel pixel, Resolution size)
{
    (void)size;
    return pixel.row == 0;
}

static Pixel turned(Pixel pixel, Resolution size)
{
    return (Pixel){size.width - 1 - pixel.column, size.height - 1 - pixel.row};
}

static Pixel next_one(Pixel pixel, Resolution size)
{
    (void)size;
    return (Pixel){pixel.column + 1, pixel.row + 1};
}

static Pixel always_the_first(Pixel pixel, Resolution size)
{
    (void)size;
    (void)pixel;
    return (Pixel){0, 0};
}

static Color sphere_0_is_nothing(const Scene *scene, int sphere)
{
    return sphere > 0 ? flat_color(scene, sphere) : scene->background;
}

static Color always_background(const Scene *scene, int sphere)
{
    (void)sphere;
    return scene->background;
}

IMAGE_ORDER(first_column_left_out, .left_out = in_first_column)
IMAGE_ORDER(first_row_left_out, .left_out = in_first_row)
IMAGE_ORDER(last_column_left_out, .left_out = in_last_column)
IMAGE_ORDER(last_row_left_out, .left_out = in_last_row)
IMAGE_ORDER(upside_down, .ray_of = row_from_below)
IMAGE_ORDER(mirrored, .ray_of = column_from_the_right)
IMAGE_ORDER(turned_by_180, .ray_of = turned)
IMAGE_ORDER(transposed, .ray_of = row_and_column_swapped)
IMAGE_ORDER(counted_from_pixel_1, .ray_of = next_one)
IMAGE_ORDER(one_ray_for_all, .ray_of = always_the_first)
IMAGE_ORDER(last_sphere_wins, .replaces = any_hit)
IMAGE_ORDER(first_sphere_wins, .replaces = hit_and_none_before)
IMAGE_ORDER(later_of_equals_wins, .replaces = nearer_or_equal)
IMAGE_ORDER(farthest_wins, .replaces = hit_and_farther)
IMAGE_ORDER(ghosts_from_behind, .t_of = near_root)
IMAGE_ORDER(inside_is_nothing, .t_of = near_root_in_front)
IMAGE_ORDER(where_spheres_end, .t_of = far_root)
IMAGE_ORDER(near_things_vanish, .t_of = hit_beyond_the_plane)
IMAGE_ORDER(first_sphere_not_seen, .color = sphere_0_is_nothing)
IMAGE_ORDER(nothing_but_background, .color = always_background)
IMAGE_ORDER(background_not_painted, .no_background = true)

// ---- other loops --------------------------------------------------------------------------------

static void rest_of_the_row_given_up(const Scene *scene, Camera camera, Image *image)
{
    for (int row = 0; row < image->size.height; row++)
        for (int column = 0; column < image->size.width; column++) {
            Pixel pixel = {column, row};
            Hit hit = nearest_hit(pixel_ray(camera, image->size, pixel), scene);
            if (hit.sphere < 0)
                break;
            image_set(image, pixel, flat_color(scene, hit.sphere));
        }
}

static void first_sphere_only(const Scene *scene, Camera camera, Image *image)
{
    Scene first = *scene;
    first.sphere_count = scene->sphere_count > 0;
    cast_image_order(&first, camera, image);
}

// Rays of their own, through the place s, t of each pixel.
static void cast_through(double right, double down, const Scene *scene, Camera camera, Image *image)
{
    Resolution size = image->size;
    for (int i = 0; i < size.width * size.height; i++) {
        Pixel pixel = pixel_number(i, size);
        double s = (pixel.column + right) / size.width, t = 1 - (pixel.row + down) / size.height;
        Ray ray = {camera.origin, image_plane_vector(camera, s, t)};
        image_set(image, pixel, flat_color(scene, nearest_hit(ray, scene).sphere));
    }
}

static void upper_left_of_the_pixel(const Scene *scene, Camera camera, Image *image)
{
    cast_through(0, 0, scene, camera, image);
}

static void half_a_pixel_twice(const Scene *scene, Camera camera, Image *image)
{
    cast_through(1, 1, scene, camera, image);
}

static void width_and_height_swapped(const Scene *scene, Camera camera, Image *image)
{
    Resolution size = image->size;
    for (int i = 0; i < size.width * size.height; i++) {
        Pixel pixel = pixel_number(i, size);
        Ray ray = pixel_ray(camera, (Resolution){size.height, size.width}, pixel);
        image_set(image, pixel, flat_color(scene, nearest_hit(ray, scene).sphere));
    }
}

static void from_the_origin_of_the_world(const Scene *scene, Camera camera, Image *image)
{
    camera.origin = vec3_of(0, 0, 0);
    cast_image_order(scene, camera, image);
}

const Mistake image_order_mistakes[] = {
    MISTAKE("I-flip", cast_image_order, upside_down, "the rows counted from the bottom",
            "row 0 of the image is the top one, and pixel_ray counts in the same way.",
            "upside down"),
    MISTAKE("I-mirror", cast_image_order, mirrored, "the columns counted from the right",
            "column 0 is the left one, and pixel_ray counts in the same way.", "mirrored"),
    MISTAKE("I-turn", cast_image_order, turned_by_180, "the pixels from the last to the first",
            "the ray of the lower right pixel colours the upper left one.",
            "turned by 180 degrees"),
    MISTAKE("P4", cast_image_order, transposed, "row and column swapped",
            "a pixel is (column, row): how far to the right, then how far down; here it gets the "
            "ray of (row, column).",
            "right and down swapped"),
    MISTAKE("I-from1", cast_image_order, counted_from_pixel_1, "the pixels counted from 1",
            "the first column and the first row are number 0; so each pixel shows its neighbour.",
            "shifted by a pixel, to the left and up"),
    MISTAKE("I-one", cast_image_order, one_ray_for_all, "the ray of the first pixel for all",
            "every pixel has its own ray.", "all in one colour"),
    MISTAKE("I-column0", cast_image_order, first_column_left_out, "column 0 not painted",
            "columns are counted from 0.", "a stripe at the left edge"),
    MISTAKE("I-row0", cast_image_order, first_row_left_out, "row 0 not painted",
            "rows are counted from 0.", "a stripe at the upper edge"),
    MISTAKE("I-column", cast_image_order, last_column_left_out, "the last column not painted",
            "counted from 0, the last of w columns is number w - 1, and it must be painted.",
            "a stripe at the right edge"),
    MISTAKE("I-row", cast_image_order, last_row_left_out, "the last row not painted",
            "counted from 0, the last of h rows is number h - 1, and it must be painted.",
            "a stripe at the lower edge"),
    MISTAKE("I-size", cast_image_order, width_and_height_swapped, "width and height swapped",
            "a resolution is the number of columns, then the number of rows.",
            "spheres stretched, part of the scene cut off; right in a square image"),
    MISTAKE("P1", cast_image_order, upper_left_of_the_pixel, "rays through the pixels' corners",
            "a pixel is a small square, and its ray goes through the centre: half a pixel to the "
            "right and half a pixel down.",
            "everything moved by half a pixel, to the right and down"),
    MISTAKE("P2", cast_image_order, half_a_pixel_twice, "rays through the lower right corners",
            "from its upper left corner to its centre it is half a pixel each way, once.",
            "everything moved by half a pixel, to the left and up"),
    MISTAKE("P7", cast_image_order, from_the_origin_of_the_world, "rays from the world's origin",
            "rays start at the eye.", "moving the camera changes nothing"),
    MISTAKE("I-last", cast_image_order, last_sphere_wins, "the last hit of the list",
            "the distance decides which sphere covers another, not the order of the scene.",
            "far spheres in front of near ones, in the order of the scene"),
    MISTAKE("I-first", cast_image_order, first_sphere_wins, "the first hit of the list",
            "a sphere later in the list may be nearer.",
            "the first spheres of the scene cover everything"),
    MISTAKE("I-only", cast_image_order, first_sphere_only, "sphere 0 alone",
            "each ray must be tested against every sphere of the scene.", "one sphere only"),
    MISTAKE("I-tie", cast_image_order, later_of_equals_wins, "the last of equally near spheres",
            "of equal hits the lower index counts.",
            "another colour where two spheres touch or coincide"),
    MISTAKE("I-far", cast_image_order, farthest_wins, "the farthest hit",
            "the nearest sphere covers the farther ones.", "the scene from back to front"),
    MISTAKE("R6-image", cast_image_order, where_spheres_end,
            "spheres compared by where rays leave them",
            "the eye sees the point where the ray enters. A large sphere may start in front of a "
            "small one and end behind it.",
            "small spheres seen through large ones"),
    MISTAKE("R7-image", cast_image_order, ghosts_from_behind, "the smallest t, even below 0",
            "a ray starts at the eye. Hits with t < 0 are behind the eye.",
            "ghosts of the spheres behind the eye, mirrored and upside down"),
    MISTAKE("R8-image", cast_image_order, inside_is_nothing, "no hit on a sphere around the eye",
            "the ray still leaves such a sphere through its far side.",
            "a sphere vanishes as soon as the eye enters it"),
    MISTAKE("D1-image", cast_image_order, near_things_vanish, "hits with t up to 1 dropped",
            "the image plane is a window, not a wall: spheres between it and the eye are visible.",
            "near spheres vanish"),
    MISTAKE("I-rest", cast_image_order, background_not_painted, "only hits painted",
            "if nothing is hit, the old colour of the image stays. Every pixel needs a colour.",
            "spheres on the old contents of the image, at first black"),
    MISTAKE("I-break", cast_image_order, rest_of_the_row_given_up,
            "a row given up at its first miss",
            "a ray that hits nothing says nothing about the next one. Its own pixel needs a colour "
            "as well.",
            "black; only spheres that touch the left edge are seen"),
    MISTAKE("I-none", cast_image_order, nothing_but_background, "the background everywhere",
            "no hit ever colours its pixel. How do you distinguish a hit from a miss?", "blank"),
    MISTAKE("I-0", cast_image_order, first_sphere_not_seen, "index 0 treated as a miss",
            "0 is the first sphere; a miss is -1.", "a hole in the shape of the first sphere"),
    {0},
};
