// expect_roots.h - expected roots: their number, and each to within an absolute tolerance.
#ifndef TESTS_JUDGE_EXPECT_ROOTS_H
#define TESTS_JUDGE_EXPECT_ROOTS_H

#include "exercises/05-quadratic.h"

// If there are fewer roots, the values of the unused t do not matter.
void expect_roots(Roots yours, Roots expected, double within);

#endif
