// switchboard.h - who answers an exercise: the reference, another function, or another process.
//
// Tests call exercises by their contract names, and a proxy (proxies.c) asks here.
#ifndef TESTS_JUDGE_SWITCHBOARD_H
#define TESTS_JUDGE_SWITCHBOARD_H

#include "tests/judge/exercise.h"

#include <stdbool.h>

// From now on the reference answers everything.
void switch_to_reference(void);

// From now on this function answers the exercise. False if there is no exercise of this name.
bool switch_one(const char *exercise, AnyFunction *answer);

// Answers that are linked into this program, in the list's order; NULL: there is none. The linker
// has renamed them: an answer's upper_left is answer_upper_left here, so that upper_left is the
// proxy (reference/proxies.c). An answer calls the exercises of its own stem directly, and those of
// other stems through the proxies.
extern AnyFunction *const direct_answers[];

// From now on the transport (message.h) answers the exercises of this stem, each in its own
// tests.
void switch_to_process(const char *stem);

// From now on it answers everything, in whatever test.
void switch_all_to_process(void);

// The function that answers exercise number i in this process; NULL: call the transport.
AnyFunction *local_answer(int i);

#endif
