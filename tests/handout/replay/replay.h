// replay.h - the tests of a table, run again with any answer.
#ifndef TESTS_TOLD_REPLAY_H
#define TESTS_TOLD_REPLAY_H

#include "tests/handout/replay/table.h"

// Of the stem that was chosen.
const Told *told_table(void);

// The call that is being made.
const ToldCall *told_now(void);

// A result must agree with the table, within the tolerance of its test. If it does not, both values
// are kept as text and the test ends. results: the types of the result; size: of the call's image.
void told_expect(const char *results, const ToldCall *call, const Numbers *yours, Resolution size);

#endif
