// reference_answers.c - the solution of a chapter (SOLUTION, ANSWERED), whose calls of an exercise
// are answered by whoever has its name: the solution's own functions are weak, and have a second
// name.
#include SOLUTION

#include "tests/judge/parameters.h"

#include "tests/exercises.def" // the contracts

#define CHAPTER(number) (ANSWERED == number)
#define EXERCISE(stem, result, name, parameters, ...)                                              \
    result referred_##name(DECLARED(parameters)) __attribute__((alias(#name)));
#include "tests/exercises.def"
