// direct_answers.c - answers that are linked into this program, in the list's order.
#include "tests/judge/exercise.h"

#include <stddef.h>

#define EXERCISE(stem, result, name, ...) AnyFunction answer_##name __attribute__((weak));
#include "tests/exercises.def"
#define EXERCISE(stem, result, name, ...) answer_##name,
AnyFunction *const direct_answers[EXERCISE_COUNT] = {
#include "tests/exercises.def"
};
