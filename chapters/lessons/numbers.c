// numbers.c - the numbers of the lessons and slides, computed for the example by the functions of
// the exercises, so that they agree with the figures beside them.
#include "chapters/lessons/numbers.h"

#include "chapters/02-cameras/forms.h"
#include "chapters/shared/digits.h"
#include "chapters/shared/example.h"
#include "common/shown.h"
#include "common/text.h"
#include "exercises/01-corners.h"
#include "exercises/03-screen.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---- numbers and their names --------------------------------------------------------------------

enum { MOST_NAMES = 200 };

static NamedNumber numbers[MOST_NAMES];
static int number_count;

__attribute__((format(printf, 2, 3))) static void text(const char *name, const char *format, ...)
{
    if (number_count == MOST_NAMES) {
        fprintf(stderr, "%s: there is room for %d names only\n", name, MOST_NAMES);
        exit(2);
    }
    NamedNumber *value = &numbers[number_count++];
    value->name = name;
    va_list list;
    va_start(list, format);
    vsnprintf(value->text, sizeof value->text, format, list);
    va_end(list);
}

static void number_to(const char *name, double x, int digits)
{
    text(name, "%s", number_shown_to(x, digits).s);
}

static void number(const char *name, double x)
{
    number_to(name, x, SHOWN_DIGITS);
}

static void vector(const char *name, vec3 v)
{
    text(name, "%s", vec3_shown(v).s);
}

// A point on the screen, or (s, t).
static void pair(const char *name, double x, double y, int digits)
{
    text(name, "%s", pair_shown_to(x, y, digits).s);
}

// As a term of a sum: + 0.3 or − 0.2.
static void term(const char *name, double x)
{
    text(name, "%s %s", x < 0 ? "\u2212" : "+", number_shown(fabs(x)).s);
}

static bool is_exact(double x)
{
    return strcmp(number_shown(x).s, number_shown_to(x, 12).s) == 0;
}

// = or, if any coordinate is shown rounded, \approx.
static void equals(const char *name, vec3 v)
{
    text(name, "%s", is_exact(v[0]) && is_exact(v[1]) && is_exact(v[2]) ? "=" : "\\approx");
}

// = 0.46875 or \approx 0.1667.
static void result(const char *name, double x, int digits)
{
    text(name, "%s %s", is_exact(x) ? "=" : "\\approx", number_shown_to(x, digits).s);
}

// As an option's argument, or in code: 2,2,-4
static void option(const char *name, vec3 v)
{
    text(name, "%s,%s,%s", number_text(v[0]).s, number_text(v[1]).s, number_text(v[2]).s);
}

// ---- the camera ---------------------------------------------------------------------------------

static double degrees_across(double distance, double width)
{
    return 2 * atan(width / 2 / distance) * 180 / PI;
}

// What happens if d is left out, and w and h stay.
static void without_dividing(Camera c)
{
    double with = degrees_across(c.distance, c.width), without = degrees_across(1, c.width);
    int digits = digits_to_tell(with, without);
    Text old = number_shown_to(with, digits), new = number_shown_to(without, digits);
    bool same = strcmp(old.s, new.s) == 0;
    text("without_dividing",
         same ? "Here $d$ is 1, so they stay."
              : "With $d = 1$ and the old $w$ and $h$ this camera would see %s degrees across, "
                "not %s.",
         new.s, old.s);
}

static void camera(Camera c)
{
    Camera twice = c, unit = with_unit_distance(c);
    twice.distance *= 2;
    twice.width *= 2;
    twice.height *= 2;
    vector("eye", c.origin);
    vector("right", c.right);
    vector("up", c.up);
    vector("forward", c.forward);
    number("d", c.distance);
    number("w", c.width);
    number("h", c.height);
    number("twice_d", twice.distance);
    text("twice_d_option", "%s", number_text(twice.distance).s);
    number("twice_w", twice.width);
    number("twice_h", twice.height);
    number("quarter_d", c.distance / 4);
    number("tenth_d", 0.1 * c.distance);
    number("unit_w", unit.width);
    number("unit_h", unit.height);
    number("degrees", degrees_across(c.distance, c.width));
    number("degrees_zoomed", degrees_across(twice.distance, c.width));
    without_dividing(c);
    vector("twice_upper_left", upper_left(twice));
    vector("unit_upper_left", upper_left(unit));
    text("other_eye", "%s", vec3_length(c.origin) > 0 ? "0,0,0" : "2,2,-4");
    // A ball straight ahead, with its front 0.375 of the way to the image plane.
    number("front", 0.375 * c.distance);
    vector("front_point", c.origin + 0.375 * c.distance * c.forward);
}

static void corners(Camera c)
{
    vec3 corner = upper_left(c);
    vector("upper_left", corner);
    vector("upper_right", upper_right(c));
    vector("lower_left", image_plane_vector(c, 0, 0));
    vector("lower_right", image_plane_vector(c, 1, 0));
    vector("middle", image_plane_vector(c, 0.5, 0.5));
    vector("across_30_up_10", across_30_up_10(c));
    option("upside_down", image_plane_vector(c, 0.3, 0.9));
    number("corner_squared", vec3_dot(corner, corner));
    number("corner_length", vec3_length(corner));
    number("twice_corner", 2 * vec3_length(corner));
}

static void place(Camera c, Normalized at)
{
    vec3 v = image_plane_vector(c, at.s, at.t);
    pair("place", at.s, at.t, SHOWN_DIGITS);
    number("s", at.s);
    number("t", at.t);
    number("percent_across", 100 * at.s);
    number("percent_up", 100 * at.t);
    term("place_sideways", at.s - 0.5);
    term("place_upward", at.t - 0.5);
    equals("is_place", v);
    vector("place_vector", v);
}

static const char *const handedness_names[] = {
    [RIGHT_HANDED] = "right-handed", [LEFT_HANDED] = "left-handed"};

static void handedness(Camera c)
{
    bool left = handedness_of(c) == LEFT_HANDED;
    vector("right_x_up", vec3_cross(c.right, c.up));
    text("same_as", "%s", left ? "f" : "-f");
    text("handedness", "%s", handedness_names[left ? LEFT_HANDED : RIGHT_HANDED]);
    text("other_handedness", "%s", handedness_names[left ? RIGHT_HANDED : LEFT_HANDED]);
    vector("minus_right", -c.right);
}

static void other_forms(Camera c)
{
    Forms forms = forms_of(c);
    vector("at", forms.look_at.at);
    number("aspect", forms.look_at.aspect);
    vector("point_upper_left", forms.points.upper_left);
    vector("point_upper_right", forms.points.upper_right);
    vector("point_lower_left", forms.points.lower_left);
    vector("point_lower_right", forms.points.lower_right);
    vector("across", forms.across);
    vector("upward", forms.upward);
    vector("mean", forms.look_at.at - c.origin);
    option("eye_option", forms.look_at.eye);
    option("at_option", forms.look_at.at);
    bool square = c.width == c.height;
    text("aspect_option", "%s%s", square ? "" : " --aspect ",
         square ? "" : number_text(forms.look_at.aspect).s);
}

// ---- the screen, a point on it, and a pixel -----------------------------------------------------

// The shape of a screen on which the example's camera shows a ball as a ball.
static void needed_screen(Camera c)
{
    double ratio = c.width / c.height;
    if (fabs(ratio - 1) < 1e-9)
        text("needed_screen", "a square screen");
    else
        text("needed_screen", "a screen whose width is %s times its height", number_shown(ratio).s);
}

static void point_on_screen(Resolution screen, ScreenPoint point, Normalized at, int digits)
{
    text("screen", "%d \\times %d", screen.width, screen.height);
    number("W", screen.width);
    text("W_in_C", "%d", screen.width);
    number("H", screen.height);
    number("almost_W", screen.width - 0.3);
    pair("point", point.x, point.y, SHOWN_DIGITS);
    number("x", point.x);
    number("y", point.y);
    result("is_point_s", at.s, digits);
    result("is_point_t", at.t, digits);
}

static void pixel_on_screen(Pixel pixel, Normalized at, int digits)
{
    ScreenPoint center = pixel_center(pixel);
    number("column", pixel.column);
    text("column_in_C", "%d", pixel.column);
    number("row", pixel.row);
    number("next_column", pixel.column + 1);
    number("next_row", pixel.row + 1);
    pair("pixel_center", center.x, center.y, SHOWN_DIGITS);
    number("center_x", center.x);
    number("center_y", center.y);
    result("is_pixel_s", at.s, digits);
    result("is_pixel_t", at.t, digits);
    pair("pixel_place", at.s, at.t, digits);
}

static void ray_of_pixel(Camera c, Ray ray, Normalized at)
{
    vec3 v = ray.direction;
    term("pixel_sideways", at.s - 0.5);
    term("pixel_upward", at.t - 0.5);
    equals("is_sum", vec3_of(at.s - 0.5, at.t - 0.5, 0));
    equals("is_pixel_vector", v);
    vector("pixel_vector", v);
    equals("is_on_plane", ray.origin + v);
    vector("on_plane", ray.origin + v);
    needed_screen(c);
}

static void screen_and_pixel(Camera c, Resolution screen, ScreenPoint point, Pixel pixel)
{
    Normalized of_point = screen_to_normalized(point, screen),
               of_pixel = screen_to_normalized(pixel_center(pixel), screen);
    int digits = place_digits(screen);
    point_on_screen(screen, point, of_point, digits);
    pixel_on_screen(pixel, of_pixel, digits);
    ray_of_pixel(c, ray_to_plane(pixel_ray(c, screen, pixel), c), of_pixel);
    // Side by side: on a large screen they differ only in later digits.
    int across = digits_to_tell(of_point.s, of_pixel.s);
    int up = digits_to_tell(of_point.t, of_pixel.t);
    int more = across > up ? across : up;
    pair("point_normalized", of_point.s, of_point.t, more);
    pair("pixel_normalized", of_pixel.s, of_pixel.t, more);
}

// ---- a ray and a sphere -------------------------------------------------------------------------

// Whether the length of the direction is 1.
static void arrow(double a)
{
    Text shown = number_shown_to(a, digits_to_tell(a, 1));
    text("arrow", strcmp(shown.s, "1") == 0 ? "as this arrow is" : "and this arrow has $a = %s$",
         shown.s);
}

// The result if a is taken for 1, as if every direction had length 1.
static void with_1(Ray ray, Sphere sphere, Quadratic q)
{
    double a = q.a;
    q.a = 1;
    Roots roots = quadratic_roots(q);
    if (fabs(a - 1) < 1e-6)
        text("with_1", "for $a$, that makes no difference here: test with another ray.");
    else if (roots.count == 0)
        text("with_1", "instead of %s, $D$ is %s, and the ray seems to miss.", number_shown(a).s,
             number_shown(q.b * q.b - 4 * q.c).s);
    else {
        double t = roots.t[0];
        double away = vec3_length(ray.origin + t * ray.direction - sphere.center);
        // More digits, if the point is almost on the sphere.
        text("with_1",
             "instead of %s, you get $t = %s$. That point is %s from the center: %s the sphere.",
             number_shown(a).s, number_shown(t).s,
             number_shown_to(away, digits_to_tell(away, sphere.radius)).s,
             away < sphere.radius ? "inside" : "outside");
    }
}

// In the example there are two. In a page, a ray that is dragged may have one, or none.
static void both_roots(Roots roots)
{
    const char *const names[] = {"t0", "t1", "before", "beyond"};
    for (int i = 0; i < 4; i++) {
        double t = roots.t[i % 2 < roots.count ? i % 2 : 0];
        if (roots.count == 0)
            text(names[i], "none");
        else
            number_to(names[i], i < 2 ? t : i == 2 ? floor(t) : ceil(t), root_digits(roots));
    }
    text("roots",
         roots.count == 1   ? "%s"
         : roots.count == 2 ? "%s \\text{ and } %s"
                            : "\\text{no number: the ray misses}",
         number_shown(roots.t[0]).s, number_shown(roots.t[1]).s);
}

static void ray_and_sphere(Ray ray, Sphere sphere)
{
    Ray object_ray = to_object_coordinates(ray, sphere);
    Quadratic q = object_quadratic(object_ray, sphere.radius);
    vector("ray_origin", ray.origin);
    vector("object_origin", object_ray.origin);
    vector("ray_direction", ray.direction);
    number("ray_length", vec3_length(ray.direction));
    vector("center", sphere.center);
    number("radius", sphere.radius);
    number_to("a", q.a, coefficient_digits(q));
    number_to("b", q.b, coefficient_digits(q));
    number_to("c", q.c, coefficient_digits(q));
    number("D", q.b * q.b - 4 * q.a * q.c);
    arrow(q.a);
    both_roots(quadratic_roots(q));
    with_1(ray, sphere, q);
}

const NamedNumber *named_numbers(const Example *example, int *count)
{
    Camera c = example->camera;
    number_count = 0;
    camera(c);
    corners(c);
    place(c, example->place);
    handedness(c);
    other_forms(c);
    screen_and_pixel(c, example_screen(), example->point, example->pixel);
    ray_and_sphere(example->ray, example->sphere);
    *count = number_count;
    return numbers;
}
