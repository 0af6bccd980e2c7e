// test_recorder.h - what a test asks of the function that it is about, and what it says to other
// answers.
#ifndef TESTS_HANDOUT_TEST_RECORDER_H
#define TESTS_HANDOUT_TEST_RECORDER_H

#include "tests/handout/replay/table.h"

// From now on the reference answers, and is listened to.
void asked_begin(void);

// Runs the test, and writes its calls down: what goes in, what the reference and each mistake make
// of it. False where the reference does not pass.
bool asked_of(ToldTest *test);

// Runs it again with another result of one of its calls. Whether it passes.
bool asked_again(const ToldTest *test, int call, const Numbers *result);

#endif
