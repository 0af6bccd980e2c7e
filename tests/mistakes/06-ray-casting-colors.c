// 06-ray-casting-colors.c - wrong answers to both orders: the colours.
#include "tests/mistakes/06-ray-casting.h"

static Color surface_of_that_number(const Scene *scene, int sphere)
{
    return sphere < 0 ? scene->background : scene->surfaces[sphere % scene->surface_count].color;
}

static Color first_surface(const Scene *scene, int sphere)
{
    return sphere < 0 ? scene->background : scene->surfaces[0].color;
}

static Color blue_green_red(const Scene *scene, int sphere)
{
    Color color = flat_color(scene, sphere);
    return vec3_of(color[2], color[1], color[0]);
}

static Color times_255(const Scene *scene, int sphere)
{
    return 255 * flat_color(scene, sphere);
}

static Color black_background(const Scene *scene, int sphere)
{
    return sphere < 0 ? vec3_of(0, 0, 0) : flat_color(scene, sphere);
}

static Color through_255(const Scene *scene, int sphere)
{
    return flat_color(scene, sphere) / 255;
}

// The background as it is.
static Color surface_times_255(const Scene *scene, int sphere)
{
    return sphere < 0 ? scene->background : times_255(scene, sphere);
}

static Color surface_through_255(const Scene *scene, int sphere)
{
    return sphere < 0 ? scene->background : through_255(scene, sphere);
}

#define IN_BOTH_ORDERS(slip)                                                                       \
    IMAGE_ORDER(image_##slip, .color = slip)                                                       \
    OBJECT_ORDER(object_##slip, .color = slip)

IN_BOTH_ORDERS(black_background)
IN_BOTH_ORDERS(surface_of_that_number)
IN_BOTH_ORDERS(first_surface)
IN_BOTH_ORDERS(blue_green_red)
IN_BOTH_ORDERS(times_255)
IN_BOTH_ORDERS(through_255)
IN_BOTH_ORDERS(surface_times_255)
IN_BOTH_ORDERS(surface_through_255)

// The two rows of the table for such a slip.
#define BOTH(id, slip, formula, why, picture)                                                      \
    MISTAKE("I-" id, cast_image_order, image_##slip, formula, why, picture),                       \
        MISTAKE("O-" id, cast_object_order, object_##slip, formula, why, picture)

const Mistake color_mistakes[] = {
    BOTH("black", black_background, "black where nothing is hit",
         "the scene says what its background is.", "spheres on black"),
    BOTH("index", surface_of_that_number, "the surface of the sphere's number",
         "spheres and surfaces are counted apart; each sphere says which surface it has.",
         "spheres in each other's colours"),
    BOTH("white", first_surface, "always surface 0", "each sphere says which surface it has.",
         "all spheres in one colour"),
    BOTH("bgr", blue_green_red, "blue, green, red", "the first of the three numbers is red.",
         "red and blue exchanged"),
    BOTH("255", times_255, "colours times 255",
         "colours go from 0 to 1; the image makes bytes of them.", "whatever is not black glares"),
    BOTH("1/255", through_255, "colours divided by 255",
         "colours already go from 0 to 1; the image makes bytes of them.", "nearly black"),
    BOTH("255-surface", surface_times_255, "the surface's colour times 255",
         "colours go from 0 to 1, those of surfaces too; the image makes bytes of them.",
         "glaring spheres on the right background"),
    BOTH("1/255-surface", surface_through_255, "the surface's colour divided by 255",
         "colours already go from 0 to 1, those of surfaces too; the image makes bytes of them.",
         "nearly black spheres on the right background"),
    {0},
};
