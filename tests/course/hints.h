// hints.h - one hint more each time it is asked for; from the start again after the answer changed.
#ifndef TESTS_COURSE_HINTS_H
#define TESTS_COURSE_HINTS_H

#include "tests/course/page.h"

// hints: a file (exercises/NN-stem.hints) with a section '# FUNCTION' for each exercise. A hint
// begins with '- ', lines that continue it with two blanks. state: a file that remembers what was
// shown: the function, the hash of the answer's text, how many hints. Returns an exit status.
int hint_next(const Page *page, const char *stem, const char *hints, const char *function,
              const char *answer, const char *state);

#endif
