// digits.h - how many digits numbers need that are shown beside each other (common/shown.h): the
// same in figures, on slides and in lessons.
#ifndef CHAPTERS_SHARED_DIGITS_H
#define CHAPTERS_SHARED_DIGITS_H

#include "common/screen.h"
#include "exercises/05-quadratic.h"

// Of (s, t): a point on a screen and the center of its pixel are two places.
int place_digits(Resolution screen);

// Of a, b and c: those that are shown give b^2 - 4ac, to a hundredth of it.
int coefficient_digits(Quadratic q);

// So many that two different numbers do not look alike; most if they are the same.
int digits_to_tell(double x, double y);

// The two roots do not look alike.
int root_digits(Roots roots);

#endif
