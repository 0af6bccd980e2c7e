// recorded_calls.h - the last call of each test that was answered: of one that failed, what can be
// drawn.
#ifndef TESTS_JUDGE_RECORDED_CALLS_H
#define TESTS_JUDGE_RECORDED_CALLS_H

#include "tests/judge/wire.h"

typedef struct {
    int exercise;
    Wire question, answer; // the bytes that crossed the pipe
} Kept;

// While it is on, calls are kept; at first it is off.
void keep_calls(bool on);

// For the call: the question, and the answer.
void keep_question(int exercise, const Wire *question);
void keep_answer(const Wire *answer);

// Of the test of this number; NULL if its last call had no answer.
Kept *kept_of(int test);

#endif
