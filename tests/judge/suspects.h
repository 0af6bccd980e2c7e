// suspects.h - which known mistake a wrong answer is, and which law it breaks.
//
// A mistake is suspected until, on some input, it returns something else than the answer did. What
// is left when all tests have run agreed on all of them. Where nobody is left, the first law that
// was broken still helps.
#ifndef TESTS_JUDGE_SUSPECTS_H
#define TESTS_JUDGE_SUSPECTS_H

#include "tests/judge/mistake.h"
#include "tests/judge/switchboard.h"

#include <stdbool.h>

// Everybody is suspected again, no law is broken.
void suspects_begin(void);

// Who is left of an exercise: the nth, from 0; NULL where there are no more, or where the exercise
// was never called. extra: those too that only extra tests can tell from right.
const Mistake *suspect(int exercise, int nth, bool extra);

// Where nobody is left: who agreed on every call of all graded tests of the exercise that passed
// and of the first that failed, and explains more of the failed ones than anybody else. Something
// else is wrong, too, then. Runs the tests of the exercise again, to hear each suspect test by
// test.
const Mistake *suspect_in_part(int exercise);

// All of that about an exercise whose tests have failed: they are run again, now beside the
// mistakes and the laws, which most answers never need.
typedef struct {
    const Mistake *mistake; // NULL: not a known one
    bool in_part;           // something else is wrong, too
    const char *law;        // NULL: there is a mistake, or no law is broken that may be told
} Diagnosis;
Diagnosis diagnose(int exercise, bool hidden); // hidden: the first test that failed is

// The first law that was broken by an exercise, in words; NULL where none was. hidden: where it was
// broken only in hidden tests, too; the words tell their numbers.
const char *suspect_broke_law(int exercise, bool hidden);

// For the proxies. Goes to the next mistake of the exercise that is still suspected, from -1.
bool suspect_next(int exercise, int *i);
AnyFunction *suspect_answer(int exercise, int i);
void suspect_said(int exercise, int i, bool same);

// Whether to look at the laws of this exercise: until one is broken.
bool law_begin(int exercise);

#endif
