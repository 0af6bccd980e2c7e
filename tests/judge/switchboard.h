// switchboard.h - every exercise by its contract name, answered by whom one likes.
//
// The reference answers, but for the one that is replaced by a wrong answer. So one program runs
// the same tests against many answers.
#ifndef TESTS_JUDGE_SWITCHBOARD_H
#define TESTS_JUDGE_SWITCHBOARD_H

#include <stdbool.h>

typedef void AnyFunction(void);

// From now on the reference answers everything.
void switch_to_reference(void);

// From now on this answers the exercise of this name. False where there is no such exercise.
bool switch_one(const char *exercise, AnyFunction *answer);

// The name of exercise number i, from 0; NULL behind the last.
const char *exercise_name(int i);

#endif
