// section.h - the plane through a ray and the centre of a sphere, as a figure shows it.
//
// Whatever the ray and the sphere are, all that matters happens in that plane: a line and a circle,
// in true lengths. Data stay points of the world; two directions in the plane are the paper's.
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
    double size;  // of what has to be seen: the radius, or away where that is larger
    vec3 right, up;

    // How much of the line is shown.
    double low, high; // from which t to which
    bool near;        // is p in sight, or too far away for that?
    double stride;    // from mark to mark: 1, unless that is too near or too far
    double first;     // where the arrow of v starts: at p, where that is in sight
} Section;

// With the world's up as far as possible up on the paper, and seen from where z is positive.
Section section_upright(Ray ray, Sphere sphere);

// Turned until the ray goes to the right, above the centre.
Section section_level(Ray ray, Sphere sphere);

// Makes room for a t, unless that is too far away or no number.
void section_include(Section *section, double t);

// A point of the line.
vec3 section_point(const Section *section, double t);

// When all that it has to show is included: how it is marked.
void section_end(Section *section);

// The paper's directions, and $center, $circle, $radius, $p (or, where that is too far away, the
// end of the line towards it), $v, $ahead and $behind (of p), $ticks, $nearest, $apart (from the
// centre to there).
void section_data(Plot *plot, const Section *section);

#endif
