// mistakes-object.c - wrong answers to cast_object_order: which pixels are painted, and in which
// colour.
#include "tests/06-ray-casting/mistakes.h"

// ---- slips --------------------------------------------------------------------------------------

OBJECT_ORDER(near_things_vanish, .t_of = hit_beyond_the_plane)
OBJECT_ORDER(where_spheres_end, .t_of = far_root)
OBJECT_ORDER(ghosts_from_behind, .t_of = near_root)
OBJECT_ORDER(inside_is_nothing, .t_of = near_root_in_front)
OBJECT_ORDER(background_not_painted, .no_background = true)
OBJECT_ORDER(background_where_missed, .background_where_missed = true)
OBJECT_ORDER(background_where_farther, .background_where_farther = true)
OBJECT_ORDER(first_sphere_left_out, .first_sphere = 1)
OBJECT_ORDER(last_sphere_left_out, .last_sphere = 1)
OBJECT_ORDER(last_row_left_out, .left_out = in_last_row)
OBJECT_ORDER(last_column_left_out, .left_out = in_last_column)
OBJECT_ORDER(upside_down, .ray_of = row_from_below)
OBJECT_ORDER(mirrored, .ray_of = column_from_the_right)
OBJECT_ORDER(transposed, .ray_of = row_and_column_swapped)

// ---- other loops --------------------------------------------------------------------------------

// As without the braces of an if: the statements for nearer hits are executed for every pixel.
static void every_pixel_painted(const Scene *scene, Camera camera, Image *image, double *depth)
{
    cast_object_order(scene, camera, image, depth);
    for (int i = 0; i < image->size.width * image->size.height; i++)
        image_set(image, pixel_number(i, image->size), flat_color(scene, scene->sphere_count - 1));
}

static void first_sphere_only(const Scene *scene, Camera camera, Image *image, double *depth)
{
    Scene first = *scene;
    first.sphere_count = scene->sphere_count > 0;
    cast_object_order(&first, camera, image, depth);
}

static void rays_from_the_origin(const Scene *scene, Camera camera, Image *image, double *depth)
{
    camera.origin = vec3_of(0, 0, 0);
    cast_object_order(scene, camera, image, depth);
}

const Mistake object_order_mistakes[] = {
    MISTAKE("D1-object", cast_object_order, near_things_vanish, "hits with t up to 1 dropped",
            "the image plane is a window, not a wall: spheres between it and the eye are visible.",
            "near spheres vanish"),
    MISTAKE("R6-object", cast_object_order, where_spheres_end,
            "the t where the ray leaves the sphere",
            "the ray enters a sphere before it leaves it, and the eye sees the side that faces it.",
            "small spheres seen through large ones"),
    MISTAKE("R7-object", cast_object_order, ghosts_from_behind, "the smallest t, even below 0",
            "a ray starts at the eye. Hits with t < 0 are behind the eye.",
            "ghosts of the spheres behind the eye, mirrored and upside down"),
    MISTAKE("R8-object", cast_object_order, inside_is_nothing, "no hit on a sphere around the eye",
            "the ray still leaves such a sphere through its far side.",
            "a sphere vanishes as soon as the eye enters it"),
    MISTAKE("O-rest", cast_object_order, background_not_painted, "only hits painted",
            "if nothing is hit, the old colour of the image stays. Every pixel needs a colour.",
            "spheres on the old contents of the image, at first black"),
    MISTAKE("O-wipe", cast_object_order, background_where_missed,
            "each sphere erases the pixels where it is missed",
            "another sphere may already be visible there. A miss says nothing about the others.",
            "only the last sphere"),
    MISTAKE(
        "O-else", cast_object_order, background_where_farther,
        "each sphere erases the pixels where it is not the nearest so far",
        "the colours of other spheres must stay. Paint the background once, before all spheres.",
        "the last sphere, with holes where others are in front of it"),
    MISTAKE("O-braces", cast_object_order, every_pixel_painted, "every sphere paints every pixel",
            "the depths are right, but the colour changes whether the sphere is nearer or not. An "
            "if without braces ends after one statement.",
            "everything in the last sphere's colour"),
    MISTAKE("O-from1", cast_object_order, first_sphere_left_out, "sphere 0 left out",
            "spheres are counted from 0.", "the first sphere of the scene is missing"),
    MISTAKE("O-last", cast_object_order, last_sphere_left_out, "the last sphere left out",
            "counted from 0, the last of n spheres has the index n - 1, and it must be tested.",
            "the last sphere of the scene is missing"),
    MISTAKE("O-only", cast_object_order, first_sphere_only, "sphere 0 alone",
            "every sphere of the scene must be tested.", "one sphere only"),
    MISTAKE("O-row", cast_object_order, last_row_left_out, "no sphere in the last row",
            "counted from 0, the last of h rows is number h - 1, and it must be painted.",
            "a stripe of background at the lower edge"),
    MISTAKE("O-column", cast_object_order, last_column_left_out, "no sphere in the last column",
            "counted from 0, the last of w columns is number w - 1, and it must be painted.",
            "a stripe of background at the right edge"),
    MISTAKE("O-flip", cast_object_order, upside_down, "the rows counted from the bottom",
            "row 0 of the image is the top one, and pixel_ray counts in the same way.",
            "upside down"),
    MISTAKE("O-mirror", cast_object_order, mirrored, "the columns counted from the right",
            "column 0 is the left one, and pixel_ray counts in the same way.", "mirrored"),
    MISTAKE("P4-object", cast_object_order, transposed, "row and column swapped",
            "a pixel is (column, row): how far to the right, then how far down; here it gets the "
            "ray of (row, column).",
            "right and down swapped"),
    MISTAKE("P7-object", cast_object_order, rays_from_the_origin, "rays from the world's origin",
            "rays start at the eye.", "moving the camera changes nothing"),
    {0},
};
