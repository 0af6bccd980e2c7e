// figures.h - the figures of chapter 05.
#ifndef CHAPTERS_05_QUADRATIC_FIGURES_FIGURES_H
#define CHAPTERS_05_QUADRATIC_FIGURES_FIGURES_H

#include "common/figure/plot.h"
#include "common/ray.h"
#include "common/sphere.h"
#include "exercises/05-quadratic.h"

// A ray and a sphere.
typedef struct {
    Ray ray;
    Sphere sphere;
} Meeting;

extern const Figure quadratic_figures[]; // of a Meeting

// ---- a quadratic, its roots and their places, as data of figures --------------------------------

// The number of roots to show, and one of them; NaN if there is none.
int roots_shown(Roots roots);
double root_shown(Roots roots, int i);

// The quadratic by the answers, in object coordinates.
Quadratic quadratic_of(const Meeting *m);

// f(t) = |p + tv|^2 - r^2, by its coefficients.
double quadratic_value(Quadratic q, double t);

// PREFIXname, valid until the next call.
const char *joined(const char *prefix, const char *name);

// PREFIXa, PREFIXb, PREFIXc and the discriminant, PREFIXD.
void coefficient_numbers(Plot *plot, const char *prefix, Quadratic q);

// PREFIXroots, the number of roots; PREFIXt0 and PREFIXt1.
void root_numbers(Plot *plot, const char *prefix, Roots roots);

// A place on the line. NaN if t is infinite or NaN, so that nothing is drawn.
void root_mark(Plot *plot, const char *name, Ray ray, double t);

// ---- five rays and a sphere: the discriminant and the signs of the roots ------------------------

// The data of that figure; given is a Meeting, and only its radius is used.
void discriminant_figure(Plot *plot, void *given);

// The same with one panel for each moment of a ray that moves from each of the five places to the
// next, and stays there for a while ($stays).
void discriminant_moments(Plot *plot, void *given);

#endif
