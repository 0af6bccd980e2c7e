// right.c - right answers to exercise 08, written in other ways.
#include "exercises/03-screen.h"
#include "exercises/05-quadratic.h"
#include "exercises/08-fast.h"

#include "tests/judge/known.h"

#include <math.h>

typedef void TangentFinder(double ahead, double aside, double r, double m[2]);

static double limited(double x, double most)
{
    return x < 0 ? 0 : x > most ? most : x;
}

static ScreenRectangle with_tangents(Camera c, Resolution screen, Sphere sphere,
                                     TangentFinder *find)
{
    vec3 to = sphere.center - c.origin;
    double ahead = vec3_dot(to, c.forward), r = sphere.radius, x[2], y[2];
    double w = screen.width, h = screen.height;
    if (ahead <= -r)
        return (ScreenRectangle){0, 0, 0, 0};
    if (ahead <= r)
        return (ScreenRectangle){0, w, 0, h};
    find(ahead, vec3_dot(to, c.right), r, x);
    find(ahead, vec3_dot(to, c.up), r, y);
    for (int i = 0; i < 2; i++) {
        x[i] = w / 2 + x[i] * c.distance / c.width * w;
        y[i] = h / 2 - y[i] * c.distance / c.height * h;
    }
    if (x[1] <= 0 || x[0] >= w || y[0] <= 0 || y[1] >= h)
        return (ScreenRectangle){0, 0, 0, 0};
    return (ScreenRectangle){limited(x[0], w), limited(x[1], w), limited(y[1], h),
                             limited(y[0], h)};
}

static void angles(double ahead, double aside, double r, double m[2])
{
    double middle = atan2(aside, ahead), around = asin(r / hypot(ahead, aside));
    m[0] = tan(middle - around);
    m[1] = tan(middle + around);
}

static void roots(double ahead, double aside, double r, double m[2])
{
    Roots found = quadratic_roots(
        (Quadratic){ahead * ahead - r * r, -2 * ahead * aside, aside * aside - r * r});
    m[0] = found.t[0];
    m[1] = found.t[1];
}

// The points where the tangents touch the circle, rotated by the angle whose sine is r / |c|.
static void touching_points(double ahead, double aside, double r, double m[2])
{
    double square = ahead * ahead + aside * aside, length = sqrt(square - r * r);
    for (int i = 0; i < 2; i++) {
        double turn = i == 0 ? -r : r;
        m[i] = (length * aside + turn * ahead) / (length * ahead - turn * aside);
    }
}

static void in_long_double(double ahead, double aside, double r, double m[2])
{
    long double z = ahead, x = aside, g = z * z - (long double)r * r;
    long double half = r * sqrtl(x * x + g);
    m[0] = (double)((z * x - half) / g);
    m[1] = (double)((z * x + half) / g);
}

RIGHT_LINE(sphere_rectangle, "with the angles of the tangents",
           return with_tangents(camera, screen, sphere, angles))
RIGHT_LINE(sphere_rectangle, "with quadratic_roots of chapter 05",
           return with_tangents(camera, screen, sphere, roots))
RIGHT_LINE(sphere_rectangle, "with the points that the tangents touch",
           return with_tangents(camera, screen, sphere, touching_points))
RIGHT_LINE(sphere_rectangle, "in long double",
           return with_tangents(camera, screen, sphere, in_long_double))

RIGHT(sphere_rectangle, "with angles and normalized_to_screen")
{
    vec3 to = sphere.center - camera.origin;
    double ahead = vec3_dot(to, camera.forward), r = sphere.radius, x[2], y[2];
    if (ahead <= -r)
        return (ScreenRectangle){.right = 0};
    if (ahead <= r)
        return (ScreenRectangle){.right = screen.width, .bottom = screen.height};
    angles(ahead, vec3_dot(to, camera.right), r, x);
    angles(ahead, vec3_dot(to, camera.up), r, y);
    ScreenPoint corner[2];
    for (int i = 0; i < 2; i++)
        corner[i] =
            normalized_to_screen((Normalized){0.5 + x[i] * camera.distance / camera.width,
                                              0.5 + y[1 - i] * camera.distance / camera.height},
                                 screen);
    bool seen = corner[1].x > 0 && corner[0].x < screen.width && corner[1].y > 0 &&
                corner[0].y < screen.height;
    return (ScreenRectangle){
        seen ? fmax(corner[0].x, 0) : 0, seen ? fmin(corner[1].x, screen.width) : 0,
        seen ? fmax(corner[0].y, 0) : 0, seen ? fmin(corner[1].y, screen.height) : 0};
}
