// digits.c - how many digits numbers need that are shown beside each other.
#include "chapters/shared/digits.h"

#include "common/shown.h"

#include <math.h>
#include <string.h>

enum { FEW = SHOWN_DIGITS, MOST = 12 };

int place_digits(Resolution screen)
{
    int digits = FEW, larger = screen.width > screen.height ? screen.width : screen.height;
    while (digits < MOST && pow(10, -digits) >= 0.5 / larger)
        digits++;
    return digits;
}

static double rounded(double x, int digits)
{
    if (!isfinite(x) || x == 0)
        return x;
    double unit = pow(10, floor(log10(fabs(x))) + 1 - digits);
    return round(x / unit) * unit;
}

int coefficient_digits(Quadratic q)
{
    const double near_enough = 0.01;
    double D = q.b * q.b - 4 * q.a * q.c;
    for (int digits = FEW; digits < MOST; digits++) {
        double a = rounded(q.a, digits), b = rounded(q.b, digits), c = rounded(q.c, digits);
        if (!(fabs(b * b - 4 * a * c - D) > near_enough * fabs(D)))
            return digits;
    }
    return MOST;
}

int digits_to_tell(double x, double y)
{
    int digits = FEW;
    while (digits < MOST && strcmp(number_shown_to(x, digits).s, number_shown_to(y, digits).s) == 0)
        digits++;
    return digits;
}

int root_digits(Roots roots)
{
    return roots.count == 2 && roots.t[0] != roots.t[1] ? digits_to_tell(roots.t[0], roots.t[1])
                                                        : FEW;
}
