// accepted_results.h - the results besides the reference's that a test accepts.
#ifndef TESTS_HANDOUT_ACCEPTED_RESULTS_H
#define TESTS_HANDOUT_ACCEPTED_RESULTS_H

#include "tests/handout/replay/table.h"

// Asks it again and again with one result changed a little: tolerance, reasons, free length.
void takes_for_right(ToldTest *test);

// If one test of a function requires the exact length of a direction, the others must require it as
// well.
void agree_on_lengths(Told *told);

#endif
