// mistakes.c - wrong answers to exercise 05, one file for each kind.
//
// In formulas p, v is the ray and r the radius, as on the slides; c is the sphere's centre, or C if
// c is a coefficient.
#include "tests/05-quadratic/mistakes.h"

static const Mistake *const mistakes[] = {
    object_mistakes, world_mistakes, formula_mistakes,    plain_mistakes, count_mistakes,
    sphere_mistakes, hit_mistakes,   root_limit_mistakes, digit_mistakes, NULL,
};
OF_STEM(mistakes)
