// precompiled.h - the contracts that make has precompiled, and whether they are still the
// contracts.
//
// While a watch runs, make does not: a header that is saved then is newer than its copy.
#ifndef TESTS_COURSE_PRECOMPILED_H
#define TESTS_COURSE_PRECOMPILED_H

#include "tests/course/judging_plan.h"

#include <stdint.h>

// False if a header that the chapter's answer includes was written after it was precompiled.
bool precompiled_is_current(const JudgingPlan *plan, int chapter);

// A number that is another one after any of these files was written.
uint64_t precompiled_state(const JudgingPlan *plan, int chapter);

// The source that includes the contract, and then its standard input.
PlanPath precompiled_source(const JudgingPlan *plan, int chapter);

#endif
