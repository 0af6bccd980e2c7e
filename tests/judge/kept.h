// kept.h - the last call of each test that was answered: of one that failed, what can be drawn.
#ifndef TESTS_JUDGE_KEPT_H
#define TESTS_JUDGE_KEPT_H

#include "tests/judge/wire.h"

typedef struct {
    int exercise;
    Wire question, answer; // as they crossed the pipe
} Kept;

// While it is on, calls are kept; it is off to begin with.
void keep_calls(bool on);

// For the call: what was asked, and what came.
void keep_question(int exercise, const Wire *question);
void keep_answer(const Wire *answer);

// Of the test of this number; NULL where its last call brought no answer.
Kept *kept_of(int test);

#endif
