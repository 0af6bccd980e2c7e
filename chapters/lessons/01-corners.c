// 01-corners.c - the numbers of lesson 01.
#include "exercises/01-corners.h"

#include "chapters/lessons/fill.h"
#include "chapters/shared/example.h"
#include "common/text.h"

#include <math.h>

static double degrees_across(double width, double distance)
{
    return 2 * atan(width / 2 / distance) * 180 / PI;
}

static void fill_corners(Camera c)
{
    Normalized place = example_place();
    fill_vector("upper_left", upper_left(c));
    fill_vector("upper_right", upper_right(c));
    fill_vector("lower_left", image_plane_vector(c, 0, 0));
    fill_vector("lower_right", image_plane_vector(c, 1, 0));
    fill_vector("middle", image_plane_vector(c, 0.5, 0.5));
    fill_vector("across_30_up_10", across_30_up_10(c));
    fill_option("upside_down", image_plane_vector(c, 0.3, 0.9));
    fill_number("s", place.s);
    fill_number("t", place.t);
    fill_number("percent_across", 100 * place.s);
    fill_number("percent_up", 100 * place.t);
    fill_term("sideways", place.s - 0.5);
    fill_term("upward", place.t - 0.5);
    vec3 v = image_plane_vector(c, place.s, place.t);
    fill_equals("is_place", 3, (const double[]){v[0], v[1], v[2]});
    fill_vector("place", v);
}

// A ball straight ahead, with its front 0.375 of the way to the image plane.
static void fill_ball(Camera c)
{
    double front = 0.375 * c.distance;
    fill_number("front", front);
    fill_vector("front_point", c.origin + front * c.forward);
    fill_number("twice_d", 2 * c.distance);
    fill_text("twice_d_option", "%s", number_text(2 * c.distance).s);
    fill_number("quarter_d", c.distance / 4);
}

void fill_numbers(void)
{
    Camera c = example_camera();
    Camera unit = with_unit_distance(c);
    fill_camera(c);
    fill_corners(c);
    fill_ball(c);
    fill_number("unit_w", unit.width);
    fill_number("unit_h", unit.height);
    fill_number("degrees", degrees_across(c.width, c.distance));
    fill_number("degrees_zoomed", degrees_across(c.width, 2 * c.distance));
}
