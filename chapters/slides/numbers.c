// numbers.c - the numbers on the slides, as commands of LaTeX: \newcommand\exUpperLeft{(-1, 1, 4)}.
//
// All of them are computed by the functions of the exercises, for the lecture's example
// (chapters/example.h), so that they agree with the figures beside them.
#include "chapters/shared/example.h"
#include "common/text.h"
#include "exercises/01-corners.h"
#include "exercises/03-screen.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// Digits that people read from the last row.
enum { FEW = 4 };

static void put(const char *name, const char *text)
{
    printf("\\newcommand\\ex%s{%s}\n", name, text);
}

static void put_number(const char *name, double x)
{
    put(name, number_text_to(x, FEW).s);
}

static void put_vector(const char *name, vec3 v)
{
    put(name, vec3_text_to(v, FEW).s);
}

static void put_place(const char *name, Normalized place, int digits)
{
    char text[400];
    snprintf(text, sizeof text, "(%s, %s)", number_text_to(place.s, digits).s,
             number_text_to(place.t, digits).s);
    put(name, text);
}

// So many digits that two different numbers do not look alike; most if they are the same.
static int digits_to_tell(double x, double y)
{
    enum { MOST = 15 };
    int digits = FEW;
    while (digits < MOST && strcmp(number_text_to(x, digits).s, number_text_to(y, digits).s) == 0)
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
    char text[400] = "Here $d$ is 1, so they stay.";
    double with = degrees_across(c.distance, c.width), without = degrees_across(1, c.width);
    int digits = digits_to_tell(with, without);
    Text old = number_text_to(with, digits), new = number_text_to(without, digits);
    if (strcmp(old.s, new.s) != 0)
        snprintf(text, sizeof text,
                 "With $d = 1$ and the old $w$ and $h$ this camera would see %s degrees across, "
                 "not %s.",
                 new.s, old.s);
    put("WithoutDividing", text);
}

// Whether the length of the direction is 1.
static void put_arrow(double a)
{
    char text[400];
    Text shown = number_text_to(a, digits_to_tell(a, 1));
    if (strcmp(shown.s, "1") == 0)
        snprintf(text, sizeof text, "as this arrow is");
    else
        snprintf(text, sizeof text, "and this arrow has $a = %s$", shown.s);
    put("Arrow", text);
}

static void camera(Camera c)
{
    Camera twice = c, unit = with_unit_distance(c);
    twice.distance *= 2;
    twice.width *= 2;
    twice.height *= 2;
    put_vector("Eye", c.origin);
    put_vector("Right", c.right);
    put_vector("Up", c.up);
    put_vector("Forward", c.forward);
    put_number("Distance", c.distance);
    put_number("Width", c.width);
    put_number("Height", c.height);
    put_number("TwiceDistance", twice.distance);
    put_number("TwiceWidth", twice.width);
    put_number("TwiceHeight", twice.height);
    put_number("UnitWidth", unit.width);
    put_number("UnitHeight", unit.height);
    put_vector("UpperLeft", upper_left(c));
    put_vector("TwiceUpperLeft", upper_left(twice));
    put_vector("UnitUpperLeft", upper_left(unit));
    put_vector("UpperRight", upper_right(c));
    put_vector("Across", across_30_up_10(c));
    put_place("Place", example_place(), FEW);
    put_without_dividing(c);
    put_vector("PlaceVector", image_plane_vector(c, example_place().s, example_place().t));
}

static void screen_and_pixel(Camera c, Resolution screen, ScreenPoint point, Pixel pixel)
{
    char text[100];
    snprintf(text, sizeof text, "%d \\times %d", screen.width, screen.height);
    put("Screen", text);
    put_number("ScreenWidth", screen.width);
    put_number("ScreenHeight", screen.height);
    put("Point", pair_text(point.x, point.y).s);
    put_number("PointX", point.x);
    put_number("PointY", point.y);
    // A point, and the centre of its pixel: on a large screen they differ only in later digits.
    Normalized of_point = screen_to_normalized(point, screen),
               of_pixel = screen_to_normalized(pixel_center(pixel), screen);
    int across = digits_to_tell(of_point.s, of_pixel.s),
        up = digits_to_tell(of_point.t, of_pixel.t);
    int digits = across > up ? across : up;
    put_place("PointNormalized", of_point, digits);
    put_number("Column", pixel.column);
    put_number("Row", pixel.row);
    put_place("PixelNormalized", of_pixel, digits);
    put_vector("PixelVector", pixel_ray(c, screen, pixel).direction);
}

static void ray_and_sphere(Ray ray, Sphere sphere)
{
    Ray object_ray = to_object_coordinates(ray, sphere);
    Quadratic q = object_quadratic(object_ray, sphere.radius);
    Roots roots = quadratic_roots(q);
    put_vector("RayOrigin", object_ray.origin);
    put_vector("RayDirection", object_ray.direction);
    put_number("Radius", sphere.radius);
    put_number("A", q.a);
    put_arrow(q.a);
    put_number("B", q.b);
    put_number("C", q.c);
    char text[400] = "\\text{no number: the ray misses}";
    if (roots.count == 1)
        snprintf(text, sizeof text, "%s", number_text_to(roots.t[0], FEW).s);
    if (roots.count == 2)
        snprintf(text, sizeof text, "%s \\text{ and } %s", number_text_to(roots.t[0], FEW).s,
                 number_text_to(roots.t[1], FEW).s);
    put("Roots", text);
}

int main(void)
{
    camera(example_camera());
    screen_and_pixel(example_camera(), example_screen(), example_point(), example_pixel());
    ray_and_sphere(example_ray(), example_sphere());
    return 0;
}
