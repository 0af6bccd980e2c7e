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

// In an image that is higher than wide this leads beyond the last depth, so there is room for that.
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
    MISTAKE("Z-kept", cast_object_order, depth_not_reset, "a depth that is not set first",
            "what is in it before is of no use. Before the first sphere nothing has been hit.",
            "holes, or nothing at all, another time all right"),
    MISTAKE("Z-minus", cast_object_order, depth_starts_at_minus_1, "depths that start at -1",
            "hits are in front of the eye, t > 0, so none is ever below -1.", "blank"),
    MISTAKE("Z-0", cast_object_order, depth_starts_at_0, "depths that start at 0",
            "hits are in front of the eye, t > 0, so none is ever below 0.", "blank"),
    MISTAKE("Z-1000", cast_object_order, depth_starts_at_1000, "depths that start at 1000",
            "scenes have no such end. Where nothing is hit the depth is NO_HIT.",
            "all right, until a sphere is farther away than that"),
    MISTAKE("Z-each", cast_object_order, depth_reset_for_each_sphere,
            "depths reset for each sphere",
            "so each forgets the spheres before it, and is painted over them even if it is "
            "farther away.",
            "far spheres in front of near ones, in the order of the scene"),
    MISTAKE("Z-never", cast_object_order, depth_not_stored, "depths that are never changed",
            "each sphere is compared with NO_HIT. A pixel has to remember how near its nearest "
            "hit so far is.",
            "far spheres in front of near ones, in the order of the scene"),
    MISTAKE("H1-object", cast_object_order, last_sphere_wins, "each sphere painted where it is hit",
            "was something nearer hit in that pixel before? That is what the depth is for.",
            "far spheres in front of near ones, in the order of the scene"),
    MISTAKE("Z-first", cast_object_order, first_sphere_wins, "pixels painted once only",
            "a sphere further down the list may be nearer, and covers what is there.",
            "what comes first in the scene covers everything"),
    MISTAKE("Z-tie", cast_object_order, later_of_equals_wins, "equal depths painted over",
            "an equal t is no nearer. Of equals the lower index is asked for.",
            "another colour where two spheres touch or coincide"),
    MISTAKE("Z-far", cast_object_order, farthest_wins, "the farthest hit",
            "the nearest sphere covers what is behind it.", "the scene from back to front"),
    MISTAKE("Z-more", cast_object_order, never_beyond_infinity, "hits with t above the depth",
            "at first the depth is NO_HIT, and no hit is farther away than that. The nearest "
            "counts.",
            "blank"),
    MISTAKE("Z-turned", cast_object_order, depth_column_by_column, "depths column by column",
            "they go row by row from the top, as a page is read.",
            "all right; but who reads the depths finds them transposed"),
    MISTAKE("Z-bottom", cast_object_order, depth_from_the_bottom, "depths from the bottom row up",
            "they go row by row from the top, as the image does.",
            "all right; but who reads the depths finds them upside down"),
    MISTAKE("Z-height", cast_object_order, depth_by_the_height, "depth[row * height + column]",
            "a row is as long as the image is wide: row * width pixels come before it.",
            "right in a square image; else parts of spheres missing"),
    MISTAKE("Z-height-set", cast_object_order, depth_set_by_the_height,
            "depth[row * height + column], there too where it is set first",
            "a row is as long as the image is wide: row * width pixels come before it.",
            "right in a square image; else parts of spheres missing"),
    MISTAKE("Z-float", cast_object_order, depth_as_float, "t as a float",
            "a float has 7 digits, a double 16, and hit_sphere's answer has as many.",
            "speckles where surfaces nearly touch"),
    MISTAKE("Z-row", cast_object_order, depth_of_one_row, "one row of depths for all rows",
            "every pixel has a depth of its own, else a sphere hides what is above and below it.",
            "parts of spheres missing"),
    MISTAKE("Z-one", cast_object_order, depth_of_one_pixel, "one depth for all pixels",
            "every pixel has a depth of its own, else a sphere hides what is beside it.",
            "here and there a pixel of a sphere"),
    MISTAKE("Z-way", cast_object_order, depth_is_a_distance, "the way to the hit",
            "the depth is t, which counts in lengths of the ray's direction; and those differ "
            "from pixel to pixel.",
            "the same picture"),
    MISTAKE("Z-none0", cast_object_order, depth_0_for_nothing, "a depth of 0 where nothing is hit",
            "0 is at the eye, nearer than all. What is not there is infinitely far: NO_HIT.",
            "the same picture"),
    MISTAKE("Z-none-1", cast_object_order, depth_minus_1_for_nothing, "-1 where nothing is hit",
            "-1 is behind the eye. What is not there is infinitely far: NO_HIT.",
            "the same picture"),
    MISTAKE("Z-own", cast_object_order, depth_in_memory_of_its_own, "depths in memory of its own",
            "the picture is right, but whoever asked for the depths has none of them.",
            "the same picture"),
    {0},
};
