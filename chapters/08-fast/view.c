// view.c - the rectangle of a sphere on the screen.
#include "chapters/08-fast/view.h"

#include <math.h>

vec3 view_center(Camera camera, Sphere sphere)
{
    vec3 c = sphere.center - camera.origin;
    return vec3_of(vec3_dot(c, camera.right), vec3_dot(c, camera.up), vec3_dot(c, camera.forward));
}

// The ends of a sphere's outline along one axis of the plane at distance 1. Seen along the other
// axis, two lines through the eye touch a circle around (ahead, aside); g = ahead^2 - r^2 > 0.
static void outline(double ahead, double aside, double r, double g, double *low, double *high)
{
    double middle = ahead * aside / g;
    double half = r * sqrt(aside * aside + g) / g;
    *low = middle - half;
    *high = middle + half;
}

static int clamped(double x, int most)
{
    return x > 0 ? x < most ? (int)x : most : 0;
}

Rectangle view_rectangle(Camera camera, Resolution screen, Sphere sphere)
{
    const Rectangle none = {0}, all = {0, screen.width, 0, screen.height};
    vec3 c = view_center(camera, sphere);
    double r = sphere.radius * (1 + 1e-9); // rounding does not make a sphere larger than that
    double g = (c[2] - r) * (c[2] + r);
    if (c[2] + r <= 0)
        return none;
    if (!(g > 0) || c[2] <= r)
        return all;
    double left, right, low, high;
    outline(c[2], c[0], r, g, &left, &right);
    outline(c[2], c[1], r, g, &low, &high);
    // From the plane at distance 1 to pixels: the screen is width / distance by height / distance
    // there.
    double x = screen.width * camera.distance / camera.width;
    double y = screen.height * camera.distance / camera.height;
    double middle_x = screen.width / 2.0, middle_y = screen.height / 2.0;
    return (Rectangle){clamped(middle_x + x * left - 1, screen.width),
                       clamped(middle_x + x * right + 2, screen.width),
                       clamped(middle_y - y * high - 1, screen.height),
                       clamped(middle_y - y * low + 2, screen.height)};
}
