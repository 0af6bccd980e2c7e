// check_example.c - says what is wrong with the numbers of the example, before anything is
// made of them. Exit status 1 if they are not an example.
#include "chapters/shared/example.h"
#include "common/text.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

__attribute__((format(printf, 1, 2), noreturn)) static void wrong_example(const char *format, ...)
{
    va_list list;
    va_start(list, format);
    fprintf(stderr, "%s: ", example_file());
    vfprintf(stderr, format, list);
    fprintf(stderr, "\n");
    va_end(list);
    exit(1);
}

static void check_length(const char *name, vec3 v)
{
    if (!(fabs(vec3_length(v) - 1) <= CAMERA_TOLERANCE))
        wrong_example("%s is %s: its length is %s, expected 1", name, vec3_text(v).s,
                      number_text(vec3_length(v)).s);
}

static void check_angle(const char *one, vec3 v, const char *other, vec3 w)
{
    double degrees = acos(vec3_dot(v, w)) * 180 / PI;
    if (!(fabs(vec3_dot(v, w)) <= CAMERA_TOLERANCE))
        wrong_example("%s %s and %s %s are at %s degrees, expected 90", one, vec3_text(v).s, other,
                      vec3_text(w).s, number_text(degrees).s);
}

static void check_positive(const char *name, double x)
{
    if (!(x > 0 && isfinite(x)))
        wrong_example("%s is %s, expected more than 0", name, number_text(x).s);
}

static void check_camera(Camera c)
{
    check_length("right", c.right);
    check_length("up", c.up);
    check_length("forward", c.forward);
    check_angle("right", c.right, "up", c.up);
    check_angle("up", c.up, "forward", c.forward);
    check_angle("forward", c.forward, "right", c.right);
    check_positive("distance", c.distance);
    check_positive("width", c.width);
    check_positive("height", c.height);
    CameraFault fault = camera_check(c);
    if (fault != CAMERA_OK)
        wrong_example("this is not a camera: %s", camera_fault_text(fault));
}

static void check_screen(Normalized place, Resolution screen, Pixel pixel)
{
    if (!(place.s >= 0 && place.s <= 1 && place.t >= 0 && place.t <= 1))
        wrong_example("place is %s, expected two numbers from 0 to 1",
                      pair_text(place.s, place.t).s);
    if (screen.width < 1 || screen.height < 1)
        wrong_example("screen is %d x %d, expected at least 1 x 1 pixels", screen.width,
                      screen.height);
    if (pixel.column < 0 || pixel.row < 0 || pixel.column >= screen.width ||
        pixel.row >= screen.height)
        wrong_example("point (%d, %d) is not a pixel of a screen of %d x %d", pixel.column,
                      pixel.row, screen.width, screen.height);
}

// The middle of the chord is ahead, p is outside, and the line passes closer than the radius.
static void check_ray(Ray ray, Sphere sphere)
{
    vec3 to_center = sphere.center - ray.origin;
    check_positive("radius", sphere.radius);
    check_positive("the length of ray-direction", vec3_length(ray.direction));
    double from_center = vec3_length(to_center), r = sphere.radius;
    double ahead = vec3_dot(to_center, vec3_unit(ray.direction));
    double away = vec3_length(to_center - ahead * vec3_unit(ray.direction));
    if (!(from_center > r))
        wrong_example("ray-origin is in the sphere: it is %s from the center, expected more than "
                      "the radius, %s",
                      number_text(from_center).s, number_text(r).s);
    if (!(away < r))
        wrong_example("the ray passes the center at %s, expected less than the radius, %s",
                      number_text(away).s, number_text(r).s);
    if (!(ahead > 0))
        wrong_example("the sphere is behind ray-origin: turn ray-direction round");
}

int main(void)
{
    check_camera(example_camera());
    check_screen(example_place(), example_screen(), example_pixel());
    check_ray(example_ray(), example_sphere());
    return 0;
}
