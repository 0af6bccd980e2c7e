// laws.c - the laws of exercise 08: a rectangle is on the screen, and the center of a sphere is in
// its rectangle.
#include "exercises/08-fast.h"

#include "common/text.h"
#include "tests/judge/known.h"

#include <math.h>
#include <stdbool.h>

// Much wider than the contract's 1e-6.
static const double noise = 1e-5;

static bool in_order(const char *low, double from, const char *high, double to, const char *size,
                     int most)
{
    if (!isfinite(from) || !isfinite(to))
        law_broken("%s or %s is not a finite number", low, high);
    else if (from > to + noise)
        law_broken("your %s, %s, is larger than your %s, %s", low, number_text(from).s, high,
                   number_text(to).s);
    else if (from < -noise || to > most + noise)
        law_broken("your rectangle reaches from %s %s to %s %s; the screen has a %s of %d", low,
                   number_text(from).s, high, number_text(to).s, size, most);
    else
        return true;
    return false;
}

// One edge: m is aside for each 1 ahead there, and inside is 1 if the sphere is on the side of
// larger m, or else -1. Its plane through the eye has to touch the sphere; at the edge of the
// screen it may cut it.
static bool touches(const char *edge, double m, double inside, bool cut_off, double aside,
                    double ahead, double r, double pixel)
{
    double slant = sqrt(1 + m * m), distance = inside * (aside - m * ahead) / slant;
    double tolerance = 1e-7 * r + noise * pixel * ahead;
    if (distance <= r + tolerance && (cut_off || distance >= r - tolerance))
        return true;
    Apart its = apart(distance, r);
    law_broken(
        "the plane through the eye and your %s edge passes %s from the center of the sphere; "
        "its radius is %s",
        edge, its.yours.s, its.right.s);
    return false;
}

// Beside the screen: on the outer side of the plane through one of its edges.
static bool is_beside(double m, double aside, double ahead, double r)
{
    return (fabs(aside) - m * ahead) / sqrt(1 + m * m) >= 0.999999 * r;
}

LAW(sphere_rectangle)
{
    double w = screen.width, h = screen.height, r = sphere.radius;
    if (!in_order("left", yours.left, "right", yours.right, "width", screen.width) ||
        !in_order("top", yours.top, "bottom", yours.bottom, "height", screen.height))
        return;
    vec3 to = sphere.center - camera.origin;
    double ahead = vec3_dot(to, camera.forward), x = vec3_dot(to, camera.right);
    double y = vec3_dot(to, camera.up);
    bool empty = yours.right <= noise && yours.bottom <= noise;
    bool all = yours.left <= noise && yours.right >= w - noise && yours.top <= noise &&
               yours.bottom >= h - noise;
    if (ahead < -1.000001 * r && !empty)
        law_broken("all of the sphere is behind the eye, and your rectangle is not empty");
    if (fabs(ahead) < 0.999999 * r && !all)
        law_broken("the eye is inside the sphere or beside it, and your rectangle is not the whole "
                   "screen");
    if (ahead < 1.01 * r)
        return;
    double half_x = camera.width / 2 / camera.distance,
           half_y = camera.height / 2 / camera.distance;
    if (empty) {
        if (!is_beside(half_x, x, ahead, r) && !is_beside(half_y, y, ahead, r))
            law_broken("your rectangle is empty, and the sphere reaches into the screen");
        return;
    }
    double across = 2 * half_x / w, up = 2 * half_y / h; // of one pixel
    (void)(touches("left", (yours.left - w / 2) * across, 1, yours.left <= noise, x, ahead, r,
                   across) &&
           touches("right", (yours.right - w / 2) * across, -1, yours.right >= w - noise, x, ahead,
                   r, across) &&
           touches("top", (h / 2 - yours.top) * up, -1, yours.top <= noise, y, ahead, r, up) &&
           touches("bottom", (h / 2 - yours.bottom) * up, 1, yours.bottom >= h - noise, y, ahead, r,
                   up));
}
