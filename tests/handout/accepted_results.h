// accepted_results.h - what else a test takes for right, besides the reference's answer.
#ifndef TESTS_HANDOUT_ACCEPTED_RESULTS_H
#define TESTS_HANDOUT_ACCEPTED_RESULTS_H

#include "tests/handout/replay/table.h"

// Asks it again and again with one result changed a little: tolerance, reasons, free length.
void takes_for_right(ToldTest *test);

// Where one test of a function wants the very direction, the others may not say otherwise.
void agree_on_lengths(Told *told);

#endif
