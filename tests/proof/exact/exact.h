// exact.h - where a ray meets a sphere, without any error.
//
// Doubles are whole numbers times a power of two, so whole numbers hold all but square roots and
// quotients, which get more digits than anybody looks at.
#ifndef TESTS_EXACT_EXACT_H
#define TESTS_EXACT_EXACT_H

#include "tests/proof/exact/rays.h"

#include <stdbool.h>

void exact_begin(void);

// Sets the case that all other functions here use.
void exact_set(Case c);

// Does the line meet the sphere? Does the ray hit it?
bool exact_meets(void);
bool exact_hits(void);

// Computes the roots of a line that meets the sphere. Root 0 or 1, and how far yours is from it.
void exact_roots(void);
double exact_root(int i);
double exact_root_error(double yours, int i);

// r^2 - l^2, where l is the distance of the line from the centre.
double exact_r_squared_less_l_squared(void);

#endif
