// numbers.h - a quadratic, its roots and where they are, as data of figures.
#ifndef CHAPTERS_05_QUADRATIC_NUMBERS_H
#define CHAPTERS_05_QUADRATIC_NUMBERS_H

#include "chapters/05-quadratic/figures/figures.h"
#include "exercises/05-quadratic.h"

// How many roots there are to show, and one of them; not a number where there is none.
int roots_shown(Roots roots);
double root_shown(Roots roots, int i);

// So many digits that the two roots are told apart.
int root_digits(Roots roots);

// The answers' quadratic, in object coordinates.
Quadratic quadratic_of(const Meeting *m);

// f(t) = |p + tv|^2 - r^2, by its coefficients.
double quadratic_value(Quadratic q, double t);

// PREFIXname, until the next call.
const char *joined(const char *prefix, const char *name);

// PREFIXa, PREFIXb, PREFIXc and the discriminant, PREFIXD.
void coefficient_numbers(Plot *plot, const char *prefix, Quadratic q, int digits);

// PREFIXroots, how many; PREFIXt0 and PREFIXt1.
void root_numbers(Plot *plot, const char *prefix, Roots roots);

// A place on the line; not a number where t is none, so that nothing is drawn.
void root_mark(Plot *plot, const char *name, Ray ray, double t);

#endif
