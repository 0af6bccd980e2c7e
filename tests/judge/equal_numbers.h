// equal_numbers.h - do two numbers agree? Within the rounding of two ways to compute the same
// thing.
//
// The result of a mistake is compared with a student's: NaN agrees with NaN here.
#ifndef TESTS_JUDGE_EQUAL_NUMBERS_H
#define TESTS_JUDGE_EQUAL_NUMBERS_H

#include <stdbool.h>

bool same_double(double a, double b);

#endif
