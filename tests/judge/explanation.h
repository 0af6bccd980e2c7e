// explanation.h - what a wrong answer is that is no known mistake by itself.
//
// It is better to say nothing than what is false. So a mistake is named only where the answer did
// what it does on several general inputs, and never did what is right where the mistake does not.
// Two are named together where they explain every call.
#ifndef TESTS_JUDGE_EXPLANATION_H
#define TESTS_JUDGE_EXPLANATION_H

#include "tests/judge/evidence.h"

// shown: the call that the student is shown; -1 where there is none. changed_since: its answer is
// another now than it was then.
Diagnosis explain_by_evidence(const Evidence *evidence, int shown, bool changed_since);

#endif
