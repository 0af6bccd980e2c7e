// direct_answers.h - answers that are linked into this program, in the list's order.
//
// The linker has renamed them: an answer's upper_left is answer_upper_left here, so that upper_left
// is the proxy (reference/proxies.c). An answer calls the exercises of its own stem directly, and
// those of other stems through the proxies.
#ifndef TESTS_JUDGE_DIRECT_ANSWERS_H
#define TESTS_JUDGE_DIRECT_ANSWERS_H

#include "tests/judge/exercise.h"

extern AnyFunction *const direct_answers[EXERCISE_COUNT]; // NULL: there is none

#endif
