// numbers.c - the numbers of the lecture, by the names that lecture.txt has for them:
// [[upper_left]].
//
// All of them are computed by the functions of the exercises, for the lecture's example
// (chapters/example.h), so that they agree with the figures beside them.
#include "chapters/lessons/fill.h"
#include "chapters/shared/example.h"
#include "common/shown.h"
#include "exercises/01-corners.h"
#include "exercises/03-screen.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// So many digits that two different numbers do not look alike; most if they are the same.
static int digits_to_tell(double x, double y)
{
    enum { MOST = 15 };
    int digits = SHOWN_DIGITS;
    while (digits < MOST && strcmp(number_shown_to(x, digits).s, number_shown_to(y, digits).s) == 0)
        digits++;
    return digits;
}

static double degrees_across(double distance, double width)
{
    return 2 * atan(width / 2 / distance) * 180 / PI;
}

// What happens if d is left out, and w and h stay.
static void put_without_dividing(Camera c)
{
    double with = degrees_across(c.distance, c.width), without = degrees_across(1, c.width);
    int digits = digits_to_tell(with, without);
    Text old = number_shown_to(with, digits), new = number_shown_to(without, digits);
    bool same = strcmp(old.s, new.s) == 0;
    fill_text("without_dividing",
              same
                  ? "Here $d$ is 1, so they stay."
                  : "With $d = 1$ and the old $w$ and $h$ this camera would see %s degrees across, "
                    "not %s.",
              new.s, old.s);
}

// Whether the length of the direction is 1.
static void put_arrow(double a)
{
    Text shown = number_shown_to(a, digits_to_tell(a, 1));
    bool is_one = strcmp(shown.s, "1") == 0;
    fill_text("arrow", is_one ? "as this arrow is" : "and this arrow has $a = %s$", shown.s);
}

static void camera(Camera c)
{
    Camera twice = c, unit = with_unit_distance(c);
    twice.distance *= 2;
    twice.width *= 2;
    twice.height *= 2;
    fill_vector("eye", c.origin);
    fill_vector("right", c.right);
    fill_vector("up", c.up);
    fill_vector("forward", c.forward);
    fill_number("d", c.distance);
    fill_number("w", c.width);
    fill_number("h", c.height);
    fill_number("twice_d", twice.distance);
    fill_number("twice_w", twice.width);
    fill_number("twice_h", twice.height);
    fill_number("unit_w", unit.width);
    fill_number("unit_h", unit.height);
    fill_vector("upper_left", upper_left(c));
    fill_vector("twice_upper_left", upper_left(twice));
    fill_vector("unit_upper_left", upper_left(unit));
    fill_vector("across_30_up_10", across_30_up_10(c));
    fill_text("place", "%s", pair_shown_to(example_place().s, example_place().t, SHOWN_DIGITS).s);
    put_without_dividing(c);
    fill_vector("place_vector", image_plane_vector(c, example_place().s, example_place().t));
}

static void screen_and_pixel(Camera c, Resolution screen, ScreenPoint point, Pixel pixel)
{
    fill_text("screen", "%d \\times %d", screen.width, screen.height);
    fill_number("W", screen.width);
    fill_number("H", screen.height);
    fill_text("point", "%s", pair_shown(point.x, point.y).s);
    fill_number("x", point.x);
    fill_number("y", point.y);
    // A point, and the center of its pixel: on a large screen they differ only in later digits.
    Normalized of_point = screen_to_normalized(point, screen),
               of_pixel = screen_to_normalized(pixel_center(pixel), screen);
    int across = digits_to_tell(of_point.s, of_pixel.s),
        up = digits_to_tell(of_point.t, of_pixel.t);
    int digits = across > up ? across : up;
    fill_text("point_normalized", "%s", pair_shown_to(of_point.s, of_point.t, digits).s);
    fill_number("column", pixel.column);
    fill_number("row", pixel.row);
    fill_text("pixel_normalized", "%s", pair_shown_to(of_pixel.s, of_pixel.t, digits).s);
    fill_vector("pixel_vector", pixel_ray(c, screen, pixel).direction);
}

static void ray_and_sphere(Ray ray, Sphere sphere)
{
    Ray object_ray = to_object_coordinates(ray, sphere);
    Quadratic q = object_quadratic(object_ray, sphere.radius);
    Roots roots = quadratic_roots(q);
    fill_vector("ray_origin", object_ray.origin);
    fill_vector("ray_direction", object_ray.direction);
    fill_number("radius", sphere.radius);
    put_arrow(q.a);
    Text first = number_shown_to(roots.t[0], SHOWN_DIGITS);
    Text second = number_shown_to(roots.t[1], SHOWN_DIGITS);
    fill_text("roots",
              roots.count == 1   ? "%s"
              : roots.count == 2 ? "%s \\text{ and } %s"
                                 : "\\text{no number: the ray misses}",
              first.s, second.s);
}

void fill_numbers(void)
{
    camera(example_camera());
    screen_and_pixel(example_camera(), example_screen(), example_point(), example_pixel());
    ray_and_sphere(example_ray(), example_sphere());
}
