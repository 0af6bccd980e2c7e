// laws.c - the laws of exercise 01: how far a vector goes along the camera's own directions.
#include "exercises/01-corners.h"

#include "common/text.h"
#include "tests/judge/law.h"

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

// Every vector from the eye to the plane goes as far ahead as the plane is, whichever place it
// leads to. Says so if this one does not.
static bool misses_the_plane(vec3 yours, Camera c)
{
    if (!vec3_is_finite(yours)) {
        law_broken("a part of %s is not a finite number", vec3_text(yours).s);
        return true;
    }
    double ahead = without_noise(vec3_dot(yours, c.forward), tolerance(c));
    if (!far_from(ahead, c.distance, c))
        return false;
    Apart a = apart(ahead, c.distance);
    if (!far_from(vec3_dot(yours - c.origin, c.forward), c.distance, c))
        law_broken("along forward your vector goes %s, but the plane is %s ahead; with the eye "
                   "subtracted, the vector would end on the plane",
                   a.yours.s, a.right.s);
    else
        law_broken("along forward your vector goes %s, but the plane is %s ahead", a.yours.s,
                   a.right.s);
    return true;
}

// The right position along right and along up, from the middle, and the names of these places.
static void law_of_place(vec3 yours, Camera c, double aside, const char *column, double above,
                         const char *row)
{
    if (misses_the_plane(yours, c))
        return;
    double along_right = without_noise(vec3_dot(yours, c.right), tolerance(c));
    double along_up = without_noise(vec3_dot(yours, c.up), tolerance(c));
    Apart right = apart(along_right, aside), up = apart(along_up, above);
    if (far_from(along_right, aside, c))
        law_broken("along right your vector goes %s from the middle of the plane; %s is at %s",
                   right.yours.s, column, right.right.s);
    else if (far_from(along_up, above, c))
        law_broken("along up your vector goes %s from the middle of the plane; %s is at %s",
                   up.yours.s, row, up.right.s);
}

LAW(upper_left)
{
    law_of_place(yours, c, -c.width / 2, "its left edge", c.height / 2, "its top edge");
}

LAW(upper_right)
{
    law_of_place(yours, c, c.width / 2, "its right edge", c.height / 2, "its top edge");
}

LAW(across_30_up_10)
{
    law_of_place(yours, c, -0.2 * c.width, "30% of the way across", -0.4 * c.height, "10% up");
}

LAW(image_plane_vector)
{
    // Far beyond the plane, rounding errors grow with s and t.
    if (fabs(s) > 1e3 || fabs(t) > 1e3)
        return;
    char column[80], row[80];
    snprintf(column, sizeof column, "s = %.40s", number_text(s).s);
    snprintf(row, sizeof row, "t = %.40s", number_text(t).s);
    law_of_place(yours, c, s * c.width - c.width / 2, column, t * c.height - c.height / 2, row);
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
    else if (another_view(yours.width, yours.distance, c.width, c.distance, "w") ||
             another_view(yours.height, yours.distance, c.height, c.distance, "h"))
        return;
    else if (!same(yours.origin, c.origin, tolerance(c))) {
        Apart a = apart_vec3(yours.origin, c.origin);
        law_broken("the eye has moved from %s to %s; other objects would hide each other",
                   a.right.s, a.yours.s);
    } else if (!same(yours.right, c.right, 1e-8) || !same(yours.up, c.up, 1e-8) ||
               !same(yours.forward, c.forward, 1e-8))
        law_broken("right, up or forward has changed; the same picture needs the same frame, of "
                   "length 1");
}
