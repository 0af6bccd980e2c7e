// switched.c - the solution of one stem, whose functions call each other through the proxies as
// everybody does: a mistake in one is seen through the others. Compiled after the solution itself,
// whose functions are weak (weak.h), for the stem with the number ANSWERED.
#include "tests/exercises.def" // the contracts

#undef CHAPTER
#define CHAPTER(number) (number == ANSWERED)
#define EXERCISE(stem, result, name, ...)                                                          \
    extern __typeof__(name) reference_##name __attribute__((alias(#name)));
#include "tests/exercises.def"
