// verdicts.c - wrong answers to exercise 01 that are not known mistakes, and the verdict on each.
#include "exercises/01-corners.h"

#include "tests/judge/known.h"

UNNAMED(with_unit_distance, NOBODY " origin, right, up, forward are 0 in every call",
        "Camera c = {0}")
{
    Camera same = {.distance = 1, .width = c.width / c.distance, .height = c.height / c.distance};
    return same;
}

UNNAMED_LINE(upper_left, NOBODY, "(int)d",
             return (int)c.distance * c.forward - c.width / 2 * c.right + c.height / 2 * c.up)

UNNAMED_LINE(upper_left, NOBODY, "the larger side for both",
             return c.distance * c.forward + fmax(c.width, c.height) / 2 * (c.up - c.right))
UNNAMED_LINE(upper_left, NOBODY, "the smaller side for both",
             return c.distance * c.forward + fmin(c.width, c.height) / 2 * (c.up - c.right))
// 'return d * f - w * 0,5 * r + h * 0,5 * u' returns what follows the last comma.
UNNAMED_LINE(upper_left, NOBODY, "0,5 for 0.5", return 5 * c.up)
UNNAMED_LINE(upper_left, NOBODY " your function returns the same", "always 0",
             return vec3_of(0, 0, 0))
UNNAMED_LINE(upper_left, NOBODY " your function returns one of its arguments", "f",
             return c.forward)

UNNAMED(upper_left, NOBODY " your function gives another result", "a counter")
{
    static int calls;
    return ++calls * c.distance * c.forward - c.width / 2 * c.right + c.height / 2 * c.up;
}

UNNAMED_LINE(upper_left, "C2-C3", "both signs",
             return c.distance * c.forward + c.width / 2 * c.right - c.height / 2 * c.up)
UNNAMED_LINE(upper_left, "C1-w and C4", "w, and no d",
             return c.forward - c.width * c.right + c.height / 2 * c.up)
UNNAMED_LINE(across_30_up_10, NOBODY, "a third",
             return c.distance * c.forward + (0.33 - 0.5) * c.width * c.right +
                    (0.1 - 0.5) * c.height * c.up)
UNNAMED_LINE(image_plane_vector, NOBODY, "s mirrored, and h twice",
             return c.distance * c.forward + (0.5 - s) * c.width * c.right +
                    2 * (t - 0.5) * c.height * c.up)
