// expect_roots.h - roots that must come out: as many, and each within an absolute tolerance.
#ifndef TESTS_JUDGE_EXPECT_ROOTS_H
#define TESTS_JUDGE_EXPECT_ROOTS_H

#include "exercises/05-quadratic.h"

// Where there are fewer roots, the t that are none do not matter.
void expect_roots(Roots yours, Roots expected, double within);

#endif
