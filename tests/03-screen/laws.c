// laws.c - the laws of exercise 03: a share of the whole is the same share of the pixels, from the
// same edge.
#include "exercises/03-screen.h"

#include "tests/judge/known.h"

// Much wider than the contract's 1e-9 of a pixel, and 1e-12 normalized.
static bool far_from(double yours, double right, double size)
{
    return !(fabs(yours - right) <= 1e-8 + 1e-11 * (size + fabs(right)));
}

static bool not_finite(double x, double y)
{
    if (isfinite(x) && isfinite(y))
        return false;
    law_broken("a part of %s is not a finite number", pair_text(x, y).s);
    return true;
}

LAW(screen_to_normalized)
{
    if (not_finite(yours.s, yours.t))
        return;
    double across = yours.s * screen.width, from_left = right.s * screen.width;
    double up = yours.t * screen.height, from_bottom = right.t * screen.height;
    if (far_from(across, from_left, screen.width)) {
        Apart a = apart(across, from_left);
        law_broken("your s, of a width of %d pixels, is %s; the point is %s from the left edge",
                   screen.width, a.yours.s, a.right.s);
    } else if (far_from(up, from_bottom, screen.height)) {
        Apart a = apart(up, from_bottom);
        law_broken("your t, of a height of %d pixels, is %s; the point is %s above the bottom edge",
                   screen.height, a.yours.s, a.right.s);
    }
}

LAW(normalized_to_screen)
{
    if (not_finite(yours.x, yours.y))
        return;
    double above = screen.height - yours.y, up = screen.height - right.y;
    if (far_from(yours.x, right.x, screen.width)) {
        Apart a = apart(yours.x, right.x);
        law_broken("your point is %s from the left edge; s = %s of a width of %d pixels is %s",
                   a.yours.s, number_text(normalized.s).s, screen.width, a.right.s);
    } else if (far_from(above, up, screen.height)) {
        Apart a = apart(above, up);
        law_broken("your point is %s above the bottom edge; t = %s of a height of %d pixels is %s",
                   a.yours.s, number_text(normalized.t).s, screen.height, a.right.s);
    }
}

// The center lies inside the pixel, and as far from one side as from the other. Says so if it does
// not.
static bool off_center(double yours, int number, const char *letter, const char *kind)
{
    double before = yours - number, behind = number + 1.0 - yours;
    if (before < 0 || behind < 0) {
        law_broken("your %s is %s, outside %s %d, which reaches from %d to %.0f", letter,
                   number_text_to(yours, 9).s, kind, number, number, number + 1.0);
        return true;
    }
    if (!far_from(before, behind, 0))
        return false;
    Apart a = apart(before, behind);
    law_broken("your %s is %s after the start of %s %d and %s before its end; a center is as far "
               "from both",
               letter, a.yours.s, kind, number, a.right.s);
    return true;
}

LAW(pixel_center)
{
    if (not_finite(yours.x, yours.y) || off_center(yours.x, pixel.column, "x", "column"))
        return;
    off_center(yours.y, pixel.row, "y", "row");
}
