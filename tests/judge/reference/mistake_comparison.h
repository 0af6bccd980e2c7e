// mistake_comparison.h - the result of the answer for a call, passed to the suspects (suspects.h)
// by the proxies.
#ifndef TESTS_JUDGE_REFERENCE_MISTAKE_COMPARISON_H
#define TESTS_JUDGE_REFERENCE_MISTAKE_COMPARISON_H

#include "tests/judge/wire.h"

// If the call is of interest: to put the arguments, and then the results. Else NULL.
Wire *hear_question(int exercise);
Wire *hear_answer(int exercise);

// Both are there.
void hear(int exercise);

#endif
