// equal_numbers.c - do two numbers agree?
#include "tests/judge/equal_numbers.h"

#include <math.h>

bool same_double(double a, double b)
{
    if (isnan(a) || isnan(b))
        return isnan(a) && isnan(b);
    if (isinf(a) || isinf(b))
        return a == b;
    return a == b || fabs(a - b) <= 1e-9 * (1 + fmin(fabs(a), fabs(b)));
}
