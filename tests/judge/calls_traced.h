// calls_traced.h - what happens when a function of an answer is entered: it is reported, and the
// memory of its variables is filled.
//
// Answers are compiled with -finstrument-functions, so that each of their functions reports when it
// is entered. An exercise that a call enters, directly or through others, may be the reason why the
// call is wrong.
#ifndef TESTS_JUDGE_CALLS_TRACED_H
#define TESTS_JUDGE_CALLS_TRACED_H

// From now on each exercise that is entered is reported once, except the one that is called.
void trace_calls_of(int exercise, void (*entered)(int other));
void trace_end(void);

// Before any function of the answer runs, the stack below is filled with this byte: now, and
// whenever one is entered. So a variable that was never set is wrong in every call, and not only
// when an earlier call has left something else there.
void fill_stack_with(int byte);

#endif
