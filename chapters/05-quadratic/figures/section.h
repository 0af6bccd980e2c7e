// section.h - the plane through a ray and the centre of a sphere, as a figure shows it.
//
// Everything that matters happens in that plane, for any ray and sphere: a line and a circle, in
// true lengths. The data are points of the world; two directions in the plane are those of the
// paper.
#ifndef CHAPTERS_05_QUADRATIC_FIGURES_SECTION_H
#define CHAPTERS_05_QUADRATIC_FIGURES_SECTION_H

#include "common/figure/plot.h"
#include "common/ray.h"
#include "common/sphere.h"

typedef struct {
    Ray ray;
    Sphere sphere;
    vec3 line;    // unit, along the ray
    vec3 off;     // unit, at right angles to it, from the centre to the line
    vec3 nearest; // the point of the line that is nearest to the centre
    double t;     // its t
    double away;  // how far it is from the centre
    double size;  // of the part that must be visible: the larger of radius and away
    vec3 right, up;

    // The part of the line that is shown.
    double low, high; // from which t to which
    bool near;        // is p shown, or is it too far away?
    double stride;    // from mark to mark: 1, unless that is too small or too large
    double first;     // the t at which the arrow of v starts: at p, if p is shown
    vec3 axis;        // from the line to the axis of t: 0, unless a figure has one of its own
    bool small_ball;  // is the sphere too small for an arrow in it?
} Section;

// The world's up is up on the paper, as far as possible, seen from the side of positive z.
Section section_upright(Ray ray, Sphere sphere);

// Turned so that the ray goes to the right, above the centre.
Section section_level(Ray ray, Sphere sphere);

// Makes room for a t, unless it is too far away or NaN.
void section_include(Section *section, double t);

// A point of the line.
vec3 section_point(const Section *section, double t);

// Chooses the marks, after everything that must be visible is included.
void section_end(Section *section);

// Says from where the section is seen, and writes $center, $circle, $radius, $p (if p is too far
// away, the end of the line towards it), $v, $ahead and $behind (of p), $nearest, $apart (from the
// centre to $nearest).
void section_data(Plot *plot, const Section *section);

// The names of p, v, the line and the sphere: those of the sphere from a step on.
void section_names(Plot *plot, const Section *section, int sphere_step);

// Writes $ticks, the marks of t, and their numbers from a step on, except those that are too near
// to one of these.
void section_marks(Plot *plot, const Section *section, int step, int count, const double *taken);

// Handles: p, v, the centre and the radius. turns: the figure turns with the ray, so p can only be
// dragged along it.
void section_handles(Plot *plot, const Section *section, bool turns);

#endif
