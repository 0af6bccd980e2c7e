// test_recorder.h - the calls that a test makes of its function, and its verdict on other results.
#ifndef TESTS_HANDOUT_TEST_RECORDER_H
#define TESTS_HANDOUT_TEST_RECORDER_H

#include "tests/handout/replay/table.h"

// From now on the reference answers, and its calls are recorded.
void asked_begin(void);

// Runs the test, and records its calls: the arguments, and the results of the reference and of each
// mistake. False if the reference does not pass.
bool asked_of(ToldTest *test);

// Runs it again with another result of one of its calls. True if it passes.
bool asked_again(const ToldTest *test, int call, const Numbers *result);

#endif
