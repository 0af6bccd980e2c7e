// digits.h - where the slide's formulas lose their digits, measured against closed forms.
#ifndef CHAPTERS_05_QUADRATIC_DIGITS_H
#define CHAPTERS_05_QUADRATIC_DIGITS_H

// Moves a ray and a sphere away from the world's origin together, and prints c in both coordinates.
void digits_lost_in_the_world(void);

// Moves a sphere away from the eye, and prints the near root from a, b, c and from sphere_roots.
void digits_lost_far_away(void);

#endif
