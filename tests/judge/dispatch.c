// dispatch.c - one call of one exercise, by its contract name. Compiled for each chapter, ANSWERED,
// so that the linker reports a missing answer; 0 is all of them.

#include "tests/judge/message.h"

#include "tests/exercises.def" // the contracts

#define CHAPTER(number) (ANSWERED == 0 || ANSWERED == number)
#define EXERCISE(stem, result, name, ...) [NUMBER_##name] = (AnyFunction *)name,
static AnyFunction *const answers[EXERCISE_COUNT] = {
#include "tests/exercises.def"
};

bool dispatch(int exercise, Numbers *in, Numbers *out)
{
    return exercise >= 0 && exercise < EXERCISE_COUNT && answers[exercise] != NULL &&
           apply(exercise, answers[exercise], in, out);
}
