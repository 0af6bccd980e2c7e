// apply.h - one call of one exercise by a function that is given: the reference, or a known
// mistake.
#ifndef TESTS_JUDGE_APPLY_H
#define TESTS_JUDGE_APPLY_H

#include "tests/judge/exercise.h"
#include "tests/judge/wire.h"

// As dispatch (dispatch.h), of any stem; made by .make/proxies.awk.
bool apply(int exercise, AnyFunction *answer, Wire *in, Wire *out);

#endif
