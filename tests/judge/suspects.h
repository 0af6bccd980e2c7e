// suspects.h - which known mistake a wrong answer is, and which law it breaks.
//
// A mistake is suspected until, on some input, it returns something else than the answer did. The
// mistakes that are left after all tests and probes agreed with the answer on all of them.
#ifndef TESTS_JUDGE_SUSPECTS_H
#define TESTS_JUDGE_SUSPECTS_H

#include "tests/judge/known.h"
#include "tests/judge/numbers.h"
#include "tests/judge/runner.h"

#include <stdbool.h>

// Every mistake of this exercise is suspected, no law is broken. -1: laws only, of all exercises.
void suspects_begin(int exercise);

// The suspects that are left: the nth, from 0; NULL if there are no more, or if the exercise was
// never called. extra: also those that only extra tests can distinguish from right.
const Mistake *suspect(int nth, bool extra);

// The first graded test or probe in which a result was not the right one, in
// whatever way the contract leaves it free; NULL if none was. Where it leaves a result free, none
// may decide which mistakes are left.
const char *suspect_differs(void);

// Probes are calls that separate mistakes and are not graded: of inputs in general position, PROBE
// in tests/NN-stem.c. They run like tests, and nothing is expected of them (run_probes in
// runner.h).

// All of that for an exercise whose tests have failed: they are run again, now with the mistakes
// and the laws, which most answers never need.
typedef struct {
    const Mistake *mistake; // NULL: not a known one
    const Mistake *other;   // a second one, if also
    bool in_part;           // something else is wrong as well
    bool also;              // both, on other inputs or in other parts of the result
    const char *law;        // in words; NULL: there is a mistake, or nothing that may be shown
} Diagnosis;
Diagnosis diagnose(int exercise, bool hidden); // hidden: the first test that failed is

// The first law that was broken by an exercise, in words; NULL if none was. They may contain
// numbers of a hidden test.
const char *suspect_broke_law(int exercise);

// A question was answered (questions.c).
void suspects_hear(int exercise, const Numbers *arguments, const Numbers *yours);

// Whether the laws are wanted in this test, and a law that is broken (known.h) is of its next call.
bool law_begin(void);

// Checks the law of the exercise, with the right result and the facts of the question.
struct Question;
void law_check(int exercise, const struct Question *question, const Numbers *yours);

#endif
