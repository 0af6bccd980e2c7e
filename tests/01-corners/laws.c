// laws.c - the laws of exercise 01: how far a vector goes along the camera's own directions.
#include "exercises/01-corners.h"

#include "common/text.h"
#include "tests/judge/known.h"

#include <stdio.h>

// Much wider than the contract's 1e-9 of the distance, width and height.
static double tolerance(Camera c)
{
    return 1e-8 * (c.distance + c.width + c.height);
}

static bool far_from(double yours, double right, Camera c)
{
    return !(fabs(yours - right) <= tolerance(c));
}

// How far a vector goes along one of the directions.
static double along(vec3 v, vec3 direction, Camera c)
{
    return without_noise(vec3_dot(v, direction), tolerance(c));
}

// Every vector from the eye to the plane goes as far ahead as the plane is, whichever place it
// leads to. Says so if this one does not.
static bool misses_the_plane(vec3 yours, vec3 right, Camera c)
{
    if (!vec3_is_finite(yours)) {
        law_broken("a part of %s is not a finite number", vec3_text(yours).s);
        return true;
    }
    double ahead = along(yours, c.forward, c), plane = along(right, c.forward, c);
    if (!far_from(ahead, plane, c))
        return false;
    Apart a = apart(ahead, plane);
    if (!far_from(vec3_dot(yours - c.origin, c.forward), plane, c))
        law_broken("along forward your vector goes %s, but the plane is %s ahead; with the eye "
                   "subtracted, the vector would end on the plane",
                   a.yours.s, a.right.s);
    else
        law_broken("along forward your vector goes %s, but the plane is %s ahead", a.yours.s,
                   a.right.s);
    return true;
}

// The position along right and along up, from the middle, and the names of these places.
static void law_of_place(vec3 yours, vec3 right, Camera c, const char *column, const char *row)
{
    if (misses_the_plane(yours, right, c))
        return;
    Apart aside = apart(along(yours, c.right, c), along(right, c.right, c));
    Apart above = apart(along(yours, c.up, c), along(right, c.up, c));
    if (far_from(vec3_dot(yours, c.right), vec3_dot(right, c.right), c))
        law_broken("along right your vector goes %s from the middle of the plane; %s is at %s",
                   aside.yours.s, column, aside.right.s);
    else if (far_from(vec3_dot(yours, c.up), vec3_dot(right, c.up), c))
        law_broken("along up your vector goes %s from the middle of the plane; %s is at %s",
                   above.yours.s, row, above.right.s);
}

LAW(upper_left)
{
    law_of_place(yours, right, c, "its left edge", "its top edge");
}

LAW(upper_right)
{
    law_of_place(yours, right, c, "its right edge", "its top edge");
}

LAW(across_30_up_10)
{
    law_of_place(yours, right, c, "30% of the way across", "10% up");
}

LAW(image_plane_vector)
{
    // Far beyond the plane, rounding errors grow with s and t.
    if (fabs(s) > 1e3 || fabs(t) > 1e3)
        return;
    char column[80], row[80];
    snprintf(column, sizeof column, "s = %.40s", number_text(s).s);
    snprintf(row, sizeof row, "t = %.40s", number_text(t).s);
    law_of_place(yours, right, c, column, row);
}

// The view depends on the size of the plane divided by its distance.
static bool another_view(double size, double distance, double size_before, double distance_before,
                         const char *letter)
{
    double now = size / distance, before = size_before / distance_before;
    if (fabs(now - before) <= 1e-8 * before)
        return false;
    Apart a = apart(now, before);
    law_broken("%s / d is now %s and was %s: the picture takes in %s", letter, a.yours.s, a.right.s,
               now > before ? "more than before" : "less than before");
    return true;
}

static bool same(vec3 v, vec3 w, double within)
{
    return vec3_length(v - w) <= within;
}

LAW(with_unit_distance)
{
    if (!(fabs(yours.distance - 1) <= 1e-8))
        law_broken("the distance must be 1, and yours is %s", apart(yours.distance, 1).yours.s);
    else if (another_view(yours.width, yours.distance, right.width, right.distance, "w") ||
             another_view(yours.height, yours.distance, right.height, right.distance, "h"))
        return;
    else if (!same(yours.origin, right.origin, tolerance(c))) {
        Apart a = apart_vec3(yours.origin, right.origin);
        law_broken("the eye has moved from %s to %s; other objects would hide each other",
                   a.right.s, a.yours.s);
    } else if (!same(yours.right, right.right, 1e-8) || !same(yours.up, right.up, 1e-8) ||
               !same(yours.forward, right.forward, 1e-8))
        law_broken("right, up or forward has changed; the same picture needs the same frame, of "
                   "length 1");
}
