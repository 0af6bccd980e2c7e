// mistakes-depth.c - wrong answers to cast_object_order: the depth.
#include "tests/06-ray-casting/mistakes.h"

#include <string.h>

// ---- slips --------------------------------------------------------------------------------------

static bool hit_and_more(double t, double depth)
{
    return t < NO_HIT && t > depth;
}

static int column_by_column(Pixel pixel, Resolution size)
{
    return pixel.column * size.height + pixel.row;
}

static int from_the_bottom(Pixel pixel, Resolution size)
{
    return (size.height - 1 - pixel.row) * size.width + pixel.column;
}

static int times_the_height(Pixel pixel, Resolution size)
{
    return pixel.row * size.height + pixel.column;
}

static int one_row_for_all(Pixel pixel, Resolution size)
{
    (void)size;
    return pixel.column;
}

static int one_for_all(Pixel pixel, Resolution size)
{
    (void)size;
    (void)pixel;
    return 0;
}

OBJECT_ORDER(depth_not_reset, .depth_kept = true)
OBJECT_ORDER(depth_starts_at_minus_1, .depth_starts_elsewhere = true, .depth_start = -1)
OBJECT_ORDER(depth_starts_at_0, .depth_starts_elsewhere = true, .depth_start = 0)
OBJECT_ORDER(depth_starts_at_1000, .depth_starts_elsewhere = true, .depth_start = 1000)
OBJECT_ORDER(depth_not_stored, .depth_not_stored = true)
OBJECT_ORDER(last_sphere_wins, .replaces = any_hit)
OBJECT_ORDER(first_sphere_wins, .replaces = hit_and_none_before)
OBJECT_ORDER(later_of_equals_wins, .replaces = nearer_or_equal)
OBJECT_ORDER(farthest_wins, .replaces = hit_and_farther)
OBJECT_ORDER(never_beyond_infinity, .replaces = hit_and_more)
OBJECT_ORDER(depth_column_by_column, .place = column_by_column)
OBJECT_ORDER(depth_from_the_bottom, .place = from_the_bottom)
OBJECT_ORDER(depth_of_one_row, .place = one_row_for_all)
OBJECT_ORDER(depth_of_one_pixel, .place = one_for_all)
OBJECT_ORDER(depth_as_float, .t_of = hit_as_float)

// ---- other loops --------------------------------------------------------------------------------

static void depth_reset_for_each_sphere(const Scene *scene, Camera camera, Image *image,
                                        double *depth)
{
    const Slips slips = {0};
    cast_nothing(&slips, scene, image, depth);
    for (int i = 0; i < scene->sphere_count; i++) {
        cast_nothing(&(Slips){.no_background = true}, scene, image, depth);
        cast_sphere(&slips, scene, i, camera, image, depth);
    }
}

static void depth_is_a_distance(const Scene *scene, Camera camera, Image *image, double *depth)
{
    Resolution size = image->size;
    cast_object_order(scene, camera, image, depth);
    for (int i = 0; i < size.width * size.height; i++)
        depth[i] *= vec3_length(pixel_ray(camera, size, pixel_number(i, size)).direction);
}

static void none_is(double t, const Scene *scene, Camera camera, Image *image, double *depth)
{
    cast_object_order(scene, camera, image, depth);
    for (int i = 0; i < image->size.width * image->size.height; i++)
        depth[i] = depth[i] < NO_HIT ? depth[i] : t;
}

static void depth_0_for_nothing(const Scene *scene, Camera camera, Image *image, double *depth)
{
    none_is(0, scene, camera, image, depth);
}

static void depth_minus_1_for_nothing(const Scene *scene, Camera camera, Image *image,
                                      double *depth)
{
    none_is(-1, scene, camera, image, depth);
}

static void depth_in_memory_of_its_own(const Scene *scene, Camera camera, Image *image,
                                       double *depth)
{
    double *own = depth_for(image);
    cast_object_order(scene, camera, image, own);
    free(own);
    (void)depth;
}

// In an image that is higher than wide this index goes past the last depth, so there is room for
// it.
static void rows_of_the_height(bool all_set_first, const Scene *scene, Camera camera, Image *image,
                               double *depth)
{
    Resolution size = image->size;
    int pixels = size.width * size.height;
    Image square = {.size = {size.width + size.height, size.width + size.height}};
    double *own = depth_for(&square);
    memcpy(own, depth, (size_t)pixels * sizeof *own);
    for (int i = 0; i < pixels; i++) {
        Pixel pixel = pixel_number(i, size);
        own[all_set_first ? i : times_the_height(pixel, size)] = NO_HIT;
        image_set(image, pixel, scene->background);
    }
    const Slips slips = {.place = times_the_height};
    for (int i = 0; i < scene->sphere_count; i++)
        cast_sphere(&slips, scene, i, camera, image, own);
    memcpy(depth, own, (size_t)pixels * sizeof *own);
    free(own);
}

static void depth_by_the_height(const Scene *scene, Camera camera, Image *image, double *depth)
{
    rows_of_the_height(true, scene, camera, image, depth);
}

static void depth_set_by_the_height(const Scene *scene, Camera camera, Image *image, double *depth)
{
    rows_of_the_height(false, scene, camera, image, depth);
}

const Mistake depth_mistakes[] = {
    MISTAKE("Z-kept", cast_object_order, depth_not_reset, "depths that are never initialised",
            "the values in depth before the call are arbitrary. Before the first sphere nothing "
            "has been hit: set every depth to NO_HIT.",
            "holes, or nothing at all, and at other times no visible difference"),
    MISTAKE("Z-minus", cast_object_order, depth_starts_at_minus_1, "depths that start at -1",
            "hits are in front of the eye, t > 0, so none is ever below -1.", "blank"),
    MISTAKE("Z-0", cast_object_order, depth_starts_at_0, "depths that start at 0",
            "hits are in front of the eye, t > 0, so none is ever below 0.", "blank"),
    MISTAKE("Z-1000", cast_object_order, depth_starts_at_1000, "depths that start at 1000",
            "a scene may be of any size. If nothing is hit the depth is NO_HIT.",
            "no visible difference, until a sphere is farther away than that"),
    MISTAKE("Z-each", cast_object_order, depth_reset_for_each_sphere,
            "depths reset for each sphere",
            "each sphere forgets the ones before it, and is painted over them even if it is "
            "farther away.",
            "far spheres in front of near ones, in the order of the scene"),
    MISTAKE("Z-never", cast_object_order, depth_not_stored, "depths that are never changed",
            "each sphere is compared with NO_HIT. A pixel must remember the t of its nearest hit "
            "so far.",
            "far spheres in front of near ones, in the order of the scene"),
    MISTAKE("H1-object", cast_object_order, last_sphere_wins,
            "each sphere painted wherever it is hit",
            "was something nearer hit in that pixel before? The depth answers that.",
            "far spheres in front of near ones, in the order of the scene"),
    MISTAKE("Z-first", cast_object_order, first_sphere_wins, "pixels painted only once",
            "a sphere later in the list may be nearer, and covers the colour that is there.",
            "the first spheres of the scene cover everything"),
    MISTAKE("Z-tie", cast_object_order, later_of_equals_wins, "painted over at equal depths",
            "an equal t is not nearer. Of equal hits the lower index counts.",
            "another colour where two spheres touch or coincide"),
    MISTAKE("Z-far", cast_object_order, farthest_wins, "the farthest hit",
            "the nearest sphere covers the farther ones.", "the scene from back to front"),
    MISTAKE("Z-more", cast_object_order, never_beyond_infinity, "hits with t above the depth",
            "at first the depth is NO_HIT, and no hit is farther away than that. The nearest hit "
            "counts.",
            "blank"),
    MISTAKE("Z-turned", cast_object_order, depth_column_by_column, "depths column by column",
            "they go row by row from the top, in reading order.",
            "no visible difference; but a caller who reads the depths finds them transposed"),
    MISTAKE("Z-bottom", cast_object_order, depth_from_the_bottom, "depths from the bottom row up",
            "they go row by row from the top, as the image does.",
            "no visible difference; but a caller who reads the depths finds them upside down"),
    MISTAKE("Z-height", cast_object_order, depth_by_the_height, "depth[row * height + column]",
            "a row is as long as the image is wide: row * width pixels come before it.",
            "right in a square image; in others parts of spheres are missing"),
    MISTAKE("Z-height-set", cast_object_order, depth_set_by_the_height,
            "depth[row * height + column], also in the loop that initialises it",
            "a row is as long as the image is wide: row * width pixels come before it.",
            "right in a square image; in others parts of spheres are missing"),
    MISTAKE("Z-float", cast_object_order, depth_as_float, "t as a float",
            "a float has 7 digits and a double 16, as many as the t of hit_sphere.",
            "speckles where surfaces nearly touch"),
    MISTAKE("Z-row", cast_object_order, depth_of_one_row, "one row of depths for all rows",
            "every pixel has its own depth: with only one row, a sphere hides those above and "
            "below it.",
            "parts of spheres missing"),
    MISTAKE("Z-one", cast_object_order, depth_of_one_pixel, "one depth for all pixels",
            "every pixel has its own depth: with only one, a sphere hides those beside it.",
            "single pixels of a sphere, here and there"),
    MISTAKE("Z-way", cast_object_order, depth_is_a_distance, "the distance to the hit",
            "the depth is t, which counts in lengths of the ray's direction; and these differ from "
            "pixel to pixel.",
            "the same picture"),
    MISTAKE("Z-none0", cast_object_order, depth_0_for_nothing, "a depth of 0 if nothing is hit",
            "0 is at the eye, nearer than all hits. A miss is infinitely far away: NO_HIT.",
            "the same picture"),
    MISTAKE("Z-none-1", cast_object_order, depth_minus_1_for_nothing, "-1 if nothing is hit",
            "-1 is behind the eye. A miss is infinitely far away: NO_HIT.", "the same picture"),
    MISTAKE("Z-own", cast_object_order, depth_in_memory_of_its_own,
            "depths in an array of your own",
            "the picture is right, but the caller also needs the depths, in the array depth.",
            "the same picture"),
    {0},
};
