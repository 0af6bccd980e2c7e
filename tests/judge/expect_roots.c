// expect_roots.c - expected roots, and both sides in words if they differ.
#include "tests/judge/expect_roots.h"

#include "tests/judge/test.h"

#include <stdio.h>
#include <string.h>

static Text roots_text(Roots roots, int digits)
{
    Text text;
    if (roots.count == 1)
        snprintf(text.s, sizeof text.s, "1 root, %.50s", number_text_to(roots.t[0], digits).s);
    else if (roots.count == 2)
        snprintf(text.s, sizeof text.s, "2 roots, %.50s and %.50s",
                 number_text_to(roots.t[0], digits).s, number_text_to(roots.t[1], digits).s);
    else
        snprintf(text.s, sizeof text.s, "%d roots", roots.count);
    return text;
}

void expect_roots(Roots yours, Roots expected, double within)
{
    bool same = yours.count == expected.count;
    for (int i = 0; same && i < expected.count; i++)
        same = fabs(yours.t[i] - expected.t[i]) <= within;
    int digits = 6;
    while (digits < 17 && !same &&
           strcmp(roots_text(yours, digits).s, roots_text(expected, digits).s) == 0)
        digits++;
    expect_law(same, roots_text(expected, digits).s, "%s", roots_text(yours, digits).s);
}
