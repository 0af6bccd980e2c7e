// 04-pixel-ray.c - the numbers of lesson 04.
#include "exercises/04-pixel-ray.h"

#include "chapters/lessons/fill.h"
#include "chapters/shared/digits.h"
#include "chapters/shared/example.h"
#include "common/shown.h"
#include "exercises/01-corners.h"
#include "exercises/03-screen.h"

#include <math.h>

static void fill_chain(Camera c, Resolution screen, Pixel pixel)
{
    ScreenPoint center = pixel_center(pixel);
    Normalized place = screen_to_normalized(center, screen);
    Ray ray = ray_to_plane(pixel_ray(c, screen, pixel), c);
    vec3 v = ray.direction, there = ray.origin + v;
    int digits = place_digits(screen);
    fill_number("W", screen.width);
    fill_number("H", screen.height);
    fill_number("column", pixel.column);
    fill_number("row", pixel.row);
    fill_number("center_x", center.x);
    fill_number("center_y", center.y);
    fill_result("is_s", place.s, digits);
    fill_result("is_t", place.t, digits);
    fill_term("sideways", place.s - 0.5);
    fill_term("upward", place.t - 0.5);
    fill_equals("is_sum", 2, (const double[]){place.s - 0.5, place.t - 0.5});
    fill_equals("is_v", 3, (const double[]){v[0], v[1], v[2]});
    fill_vector("v", v);
    fill_equals("is_there", 3, (const double[]){there[0], there[1], there[2]});
    fill_vector("on_plane", there);
}

void fill_numbers(void)
{
    Camera c = example_camera();
    vec3 corner = image_plane_vector(c, 0, 1);
    fill_camera(c);
    fill_chain(c, example_screen(), example_pixel());
    fill_text("other_eye", "%s", vec3_length(c.origin) > 0 ? "0,0,0" : "2,2,-4");
    fill_number("twice_d", 2 * c.distance);
    fill_vector("corner", corner);
    fill_number("corner_squared", vec3_dot(corner, corner));
    fill_number("corner_length", vec3_length(corner));
    fill_number("twice_corner", 2 * vec3_length(corner));
}
