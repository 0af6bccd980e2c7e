// dispatch.h - one call of one exercise; made by .make/proxies.awk for each stem.
#ifndef TESTS_JUDGE_DISPATCH_H
#define TESTS_JUDGE_DISPATCH_H

#include "tests/judge/wire.h"

// Gets the arguments, calls exercise number i, puts what came out. False where the message is bad
// or the exercise is of another stem.
// Just before the call there is one of what is here, where it is not NULL.
extern void (*before_dispatched_call)(void);

bool dispatch(int exercise, Wire *in, Wire *out);

#endif
