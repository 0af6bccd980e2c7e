// guard.h - calls an answer that may crash or never come to an end.
#ifndef TESTS_GENERATED_GUARD_H
#define TESTS_GENERATED_GUARD_H

#include "tests/proof/generated/question.h"

// Once, before the first call.
void guard_begin(void);

// From now on this function answers the tests.
void guard_answer_by(AnyFunction *answer);

// Asks. If the answer did not return, said->count is 0.
void guarded_ask(const Subject *subject, AnyFunction *answer, Question *question, Answer *said);

#endif
