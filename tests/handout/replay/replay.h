// replay.h - the tests of a table, asked again of whoever answers.
#ifndef TESTS_TOLD_REPLAY_H
#define TESTS_TOLD_REPLAY_H

#include "tests/handout/replay/table.h"

// Of the stem that was chosen.
const Told *told_table(void);

// The call that is being made.
const ToldCall *told_now(void);

// What came must be what the table says, as near as its test asks: otherwise both sides are kept,
// in words, and the test ends. results: the types of it; size: of the call's image.
void told_expect(const char *results, const ToldCall *call, const Numbers *yours, Resolution size);

#endif
