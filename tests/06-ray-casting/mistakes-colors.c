// mistakes-colors.c - wrong answers to both orders: the colours.
#include "tests/06-ray-casting/mistakes.h"

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

// The background unchanged.
static Color surface_times_255(const Scene *scene, int sphere)
{
    return sphere < 0 ? scene->background : times_255(scene, sphere);
}

static Color surface_through_255(const Scene *scene, int sphere)
{
    return sphere < 0 ? scene->background : through_255(scene, sphere);
}

static Color ambient_background(const Scene *scene, int sphere)
{
    return sphere < 0 ? scene->ambient : flat_color(scene, sphere);
}

static Color white_background(const Scene *scene, int sphere)
{
    return sphere < 0 ? vec3_of(1, 1, 1) : flat_color(scene, sphere);
}

static Color background_of_surface_0(const Scene *scene, int sphere)
{
    return sphere < 0 ? scene->surfaces[0].color : flat_color(scene, sphere);
}

static Color in_whole_numbers(const Scene *scene, int sphere)
{
    Color color = flat_color(scene, sphere);
    return vec3_of(trunc(color[0]), trunc(color[1]), trunc(color[2]));
}

static Color all_white(const Scene *scene, int sphere)
{
    (void)scene, (void)sphere;
    return vec3_of(1, 1, 1);
}

static Color all_black(const Scene *scene, int sphere)
{
    (void)scene, (void)sphere;
    return vec3_of(0, 0, 0);
}

static Color times_kd(const Scene *scene, int sphere)
{
    double kd = sphere < 0 ? 1 : scene_surface(scene, sphere)->diffuse;
    return kd * flat_color(scene, sphere);
}

static Color encoded(const Scene *scene, int sphere)
{
    Color color = flat_color(scene, sphere);
    return vec3_of(pow(color[0], 1 / 2.2), pow(color[1], 1 / 2.2), pow(color[2], 1 / 2.2));
}

static Color green_red_blue(const Scene *scene, int sphere)
{
    Color color = flat_color(scene, sphere);
    return vec3_of(color[1], color[0], color[2]);
}

static Color grey_of_it(const Scene *scene, int sphere)
{
    Color color = flat_color(scene, sphere);
    double mean = (color[0] + color[1] + color[2]) / 3;
    return vec3_of(mean, mean, mean);
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
IN_BOTH_ORDERS(ambient_background)
IN_BOTH_ORDERS(white_background)
IN_BOTH_ORDERS(background_of_surface_0)
IN_BOTH_ORDERS(in_whole_numbers)
IN_BOTH_ORDERS(all_white)
IN_BOTH_ORDERS(all_black)
IN_BOTH_ORDERS(times_kd)
IN_BOTH_ORDERS(encoded)
IN_BOTH_ORDERS(green_red_blue)
IN_BOTH_ORDERS(grey_of_it)

// The two rows of the table for such a slip.
#define BOTH(id, slip, formula, why, picture)                                                      \
    MISTAKE("I-" id, cast_image_order, image_##slip, formula, why, picture),                       \
        MISTAKE("O-" id, cast_object_order, object_##slip, formula, why, picture)

const Mistake color_mistakes[] = {
    BOTH("black", black_background, "black if nothing is hit",
         "the scene has its own background colour.", "spheres on black"),
    BOTH("index", surface_of_that_number, "the surface of the sphere's number",
         "spheres and surfaces are numbered separately; each sphere has the number of its surface.",
         "spheres in each other's colours"),
    BOTH("white", first_surface, "always surface 0", "each sphere has the number of its surface.",
         "all spheres in one colour"),
    BOTH("bgr", blue_green_red, "blue, green, red", "the first of the three numbers is red.",
         "red and blue swapped"),
    BOTH("255", times_255, "colours times 255",
         "colours go from 0 to 1; the image converts them to bytes.",
         "everything that is not black is too bright"),
    BOTH("1/255", through_255, "colours divided by 255",
         "colours already go from 0 to 1; the image converts them to bytes.", "nearly black"),
    BOTH("255-surface", surface_times_255, "the surface's colour times 255",
         "colours go from 0 to 1, also those of surfaces; the image converts them to bytes.",
         "spheres too bright on the right background"),
    BOTH(
        "1/255-surface", surface_through_255, "the surface's colour divided by 255",
        "colours already go from 0 to 1, also those of surfaces; the image converts them to bytes.",
        "nearly black spheres on the right background"),
    BOTH("ambient", ambient_background, "the ambient light if nothing is hit",
         "the scene has both, and they differ: use its background.",
         "spheres on another background"),
    BOTH("white-sky", white_background, "white if nothing is hit",
         "the scene has its own background colour.", "spheres on white"),
    BOTH("sky-surface", background_of_surface_0, "the colour of surface 0 if nothing is hit",
         "only spheres have surfaces; the scene has its own background colour.",
         "spheres on another background"),
    BOTH("int", in_whole_numbers, "colours without the digits after the decimal point",
         "colours are numbers from 0 to 1, mostly in between: keep them in a Color or in doubles.",
         "black, except where a colour is 1"),
    BOTH("all-white", all_white, "white everywhere",
         "the scene has the colours of its background and of each surface.", "white"),
    BOTH("all-black", all_black, "black everywhere",
         "the scene has the colours of its background and of each surface.", "black"),
    BOTH("kd", times_kd, "kd times the surface's colour",
         "kd is used in chapter 07: here colours are flat.", "spheres too dark"),
    BOTH("gamma", encoded, "colours to the power of 1 / 2.2",
         "the image takes colours unchanged: no gamma here.", "everything too pale"),
    BOTH("grb", green_red_blue, "green, red, blue", "the first of the three numbers is red.",
         "red and green swapped"),
    BOTH("grey", grey_of_it, "the mean of red, green and blue",
         "each of the three has its own byte in the image.", "a grey picture"),
    {0},
};
