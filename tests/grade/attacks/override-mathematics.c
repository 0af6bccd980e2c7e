// override-mathematics: fabs and sqrt of everything are 0, so that no difference is a difference.
// stem: 01-corners
// expect: graded | does not compile
// earns: nothing
#include "exercises/01-corners.h"

double fabs(double x)
{
    return 0;
}

double sqrt(double x)
{
    return 0;
}

double fmax(double x, double y)
{
    return 0;
}

vec3 upper_left(Camera c)
{
    return c.up;
}
