// calls_traced.h - which exercises an answer enters while it answers a call.
//
// Answers are compiled with -finstrument-functions, so that each of their functions reports when it
// is entered. An exercise that a call enters, directly or through others, may be the reason why the
// call is wrong.
#ifndef TESTS_JUDGE_CALLS_TRACED_H
#define TESTS_JUDGE_CALLS_TRACED_H

// From now on each exercise that is entered is reported once, except the one that is called.
void trace_calls_of(int exercise, void (*entered)(int other));
void trace_end(void);

#endif
