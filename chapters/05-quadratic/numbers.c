// numbers.c - a quadratic, its roots and their places, as data of figures.
#include "chapters/05-quadratic/numbers.h"

#include <stdio.h>

// The count of a wrong answer, or of a blank, may be any number.
int roots_shown(Roots roots)
{
    return roots.count < 0 ? 0 : roots.count > 2 ? 2 : roots.count;
}

double root_shown(Roots roots, int i)
{
    return i < roots_shown(roots) ? roots.t[i] : NAN;
}

Quadratic quadratic_of(const Meeting *m)
{
    return object_quadratic(to_object_coordinates(m->ray, m->sphere), m->sphere.radius);
}

static double discriminant(Quadratic q)
{
    return q.b * q.b - 4 * q.a * q.c;
}

// f(t) = |p + tv|^2 - r^2, by its coefficients.
double quadratic_value(Quadratic q, double t)
{
    return q.a * t * t + q.b * t + q.c;
}

const char *joined(const char *left, const char *right)
{
    static char name[40];
    snprintf(name, sizeof name, "%s%s", left, right);
    return name;
}

// PREFIXa, PREFIXb, PREFIXc and the discriminant, PREFIXD.
void coefficient_numbers(Plot *plot, const char *prefix, Quadratic q, int digits)
{
    plot_number_to(plot, joined(prefix, "a"), q.a, digits);
    plot_number_to(plot, joined(prefix, "b"), q.b, digits);
    plot_number_to(plot, joined(prefix, "c"), q.c, digits);
    plot_number_to(plot, joined(prefix, "D"), discriminant(q), digits);
}

// Enough digits to distinguish the two roots.
int root_digits(Roots roots)
{
    double apart = root_shown(roots, 1) - root_shown(roots, 0), large = fabs(root_shown(roots, 1));
    return apart > 0 && large / apart > 10 ? (int)fmin(4 + floor(log10(large / apart)), 12) : 4;
}

// PREFIXroots, how many; PREFIXt0 and PREFIXt1.
void root_numbers(Plot *plot, const char *prefix, Roots roots)
{
    plot_number(plot, joined(prefix, "roots"), roots_shown(roots));
    plot_number_to(plot, joined(prefix, "t0"), root_shown(roots, 0), root_digits(roots));
    plot_number_to(plot, joined(prefix, "t1"), root_shown(roots, 1), root_digits(roots));
}

// A place on the line. NaN if t is infinite or NaN, so that nothing is drawn.
void root_mark(Plot *plot, const char *name, Ray ray, double t)
{
    plot_point(plot, name, ray.origin + (isfinite(t) ? t : NAN) * ray.direction);
}
