// dispatch.h - for the answering process: one call of one exercise of its chapter.
#ifndef TESTS_JUDGE_DISPATCH_H
#define TESTS_JUDGE_DISPATCH_H

#include "tests/judge/wire.h"

// Gets the arguments, calls the answer, puts the results. False if the message is bad or the
// exercise is of another chapter.
bool dispatch(int exercise, Wire *in, Wire *out);

#endif
