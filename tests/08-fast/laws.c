// laws.c - the laws of exercise 08: a rectangle is on the screen, and the centre of a sphere is in
// its rectangle.
#include "tests/08-fast/laws.h"

#include "common/text.h"
#include "tests/judge/law.h"

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

void law_sphere_rectangle(ScreenRectangle yours, Camera camera, Resolution screen, Sphere sphere)
{
    if (!in_order("left", yours.left, "right", yours.right, "width", screen.width) ||
        !in_order("top", yours.top, "bottom", yours.bottom, "height", screen.height))
        return;
    vec3 c = sphere.center - camera.origin;
    double ahead = vec3_dot(c, camera.forward);
    if (ahead < 1.01 * sphere.radius)
        return;
    double x = 0.5 + vec3_dot(c, camera.right) / ahead * camera.distance / camera.width;
    double y = 0.5 - vec3_dot(c, camera.up) / ahead * camera.distance / camera.height;
    x *= screen.width;
    y *= screen.height;
    if (x < 0 || x > screen.width || y < 0 || y > screen.height)
        return;
    if (x < yours.left - noise || x > yours.right + noise || y < yours.top - noise ||
        y > yours.bottom + noise)
        law_broken(
            "the centre of the sphere is seen at %s, and your rectangle (x %s to %s, y %s to "
            "%s) does not contain it",
            pair_text(x, y).s, number_text(yours.left).s, number_text(yours.right).s,
            number_text(yours.top).s, number_text(yours.bottom).s);
}
