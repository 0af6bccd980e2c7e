// answer_calls.h - answers the judge's calls, however its messages arrive.
//
// Also in a page, where the answer is in a WebAssembly instance (chapters/book/).
#ifndef TESTS_JUDGE_ANSWER_CALLS_H
#define TESTS_JUDGE_ANSWER_CALLS_H

#include "tests/judge/message.h"

#include <stdbool.h>
#include <stddef.h>

// The program round it moves the bytes: all of them, or false.
bool answer_read(void *bytes, size_t size);
bool answer_write(const void *bytes, size_t size);
// Ends the program: the judge cannot be understood, or is gone.
_Noreturn void answer_end(void);

void answer_begin(void);
// Waits for a call and answers it. False if there is none, or it is not one of this chapter.
bool answer_call(void);
// Reports that the call that is being answered has crashed.
void answer_crashed(const Crash *crash);

// ---- when a function of the answer is entered (calls_traced.c) ---------------------------------

// Answers are compiled with -finstrument-functions, so that each of their functions reports when it
// is entered. An exercise that a call enters, directly or through others, may be the reason why the
// call is wrong.

// From now on each exercise that is entered is reported once, except the one that is called.
void trace_calls_of(int exercise, void (*entered)(int other));
void trace_end(void);

// Before any function of the answer runs, the stack below is filled with this byte: now, and
// whenever one is entered. So a variable that was never set is wrong in every call, and not only
// when an earlier call has left something else there.
void fill_stack_with(int byte);

#endif
