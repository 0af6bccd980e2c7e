// same.h - do two numbers agree? As near as rounding leaves two ways to compute the same thing.
//
// What a mistake computes is held against what a student returned: NaN agrees with NaN here.
#ifndef TESTS_JUDGE_SAME_H
#define TESTS_JUDGE_SAME_H

#include <stdbool.h>

bool same_double(double a, double b);

#endif
