// message.h - one call of an exercise as a message: its arguments there, its results back.
#ifndef TESTS_JUDGE_MESSAGE_H
#define TESTS_JUDGE_MESSAGE_H

#include "tests/judge/exercise.h"
#include "tests/judge/wire.h"

// arguments: the address of each, or the pointer itself (exercise.h). result: of the return value.
void put_arguments(Wire *wire, int exercise, void *const *arguments);
void put_results(Wire *wire, int exercise, const void *result, void *const *arguments);
void get_results(Wire *wire, int exercise, void *result, void *const *arguments);

// Gets the arguments, calls this function, puts the results. False if the message is bad.
bool apply(int exercise, AnyFunction *function, Wire *in, Wire *out);

// Called just before such a function is, if it is not NULL.
extern void (*before_call)(void);

#endif
