// proxies.h - who answers an exercise that is called by its contract name, as tests do.
#ifndef TESTS_JUDGE_REFERENCE_PROXIES_H
#define TESTS_JUDGE_REFERENCE_PROXIES_H

#include "tests/judge/exercise.h"

// From now on this function does. NULL: the transport (message.h). To begin with, the reference.
void answer_by(int exercise, AnyFunction *answer);

// Answers that are linked into this program, in the list's order; NULL: it has none. The linker has
// renamed them: an answer's upper_left is answer_upper_left here, so that upper_left is the proxy.
// Those of the stem that is chosen are called in this process, and the reference answers for all
// other stems, so that one mistake costs once. An answer calls the exercises of its own stem
// directly, and those of other stems through the proxies.
extern AnyFunction *const direct_answers[];

#endif
