// calls_traced.h - which exercises an answer enters while it answers a call.
//
// Answers are compiled with -finstrument-functions, so that each of their functions says when it is
// entered. What a call enters, itself or through others, is what it may be wrong because of.
#ifndef TESTS_JUDGE_CALLS_TRACED_H
#define TESTS_JUDGE_CALLS_TRACED_H

// From now on each exercise that is entered is said once, except the one that is called.
void trace_calls_of(int exercise, void (*entered)(int other));
void trace_end(void);

#endif
