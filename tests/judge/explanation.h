// explanation.h - explains a wrong answer that is not simply one known mistake.
//
// It is better to say nothing than something false. So a mistake is named only if the answer agrees
// with it on several general inputs, and is never right where the mistake is wrong. Two are named
// together if they explain every call.
#ifndef TESTS_JUDGE_EXPLANATION_H
#define TESTS_JUDGE_EXPLANATION_H

#include "tests/judge/evidence.h"

// shown: the call that the student is shown; -1 if there is none. changed_since: its answer is now
// different from then.
Diagnosis explain_by_evidence(const Evidence *evidence, int shown, bool changed_since);

#endif
