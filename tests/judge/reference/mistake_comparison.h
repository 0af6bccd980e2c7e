// mistake_comparison.h - the result of the answer for a call, passed to the suspects (suspects.h)
// by the proxies.
#ifndef TESTS_JUDGE_REFERENCE_MISTAKE_COMPARISON_H
#define TESTS_JUDGE_REFERENCE_MISTAKE_COMPARISON_H

#include "common/camera.h"
#include "tests/judge/numbers.h"
#include "tests/judge/switchboard.h"
#include "tests/judge/wire.h"

// If the call is of interest: to put the arguments, and then the results. Else NULL.
Wire *hear_question(int exercise);
Wire *hear_answer(int exercise);

// Both are there.
void hear(int exercise);

// The result of the reference, a mistake or another known function. A camera that is refused is so
// for all the reasons that it has in one style or another (mistake.h), of those that this stem may
// choose from: numbers.h. False if the arguments cannot be read.
bool known_result(int exercise, AnyFunction *function, Wire *arguments, Resolution *size_of_image,
                  Numbers *result);

// That returns every right result, in one style or another.
AnyFunction *right_function(int exercise);

// From the eye to the upper left, upper right, lower right and lower left one.
void reference_corners(Camera camera, vec3 corners[4]);

#endif
