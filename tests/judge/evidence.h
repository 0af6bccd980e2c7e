// evidence.h - the results of a wrong answer, the reference and each known mistake for every call.
#ifndef TESTS_JUDGE_EVIDENCE_H
#define TESTS_JUDGE_EVIDENCE_H

#include "tests/judge/suspects.h"

// The result of a mistake for a call.
typedef struct {
    Numbers numbers; // none for a picture, which has too many
    bool is_yours, is_right;
} Theirs;

typedef struct {
    int test;   // its number in the run
    bool probe; // with general arguments; a test may have special ones
    Numbers arguments, yours, right, again;
    bool is_right;  // yours is
    bool is_common; // yours is the same as for other arguments: NO_HIT, say, or 0
    bool changes;   // called again, yours returned something else
    Theirs *theirs; // of each mistake
} EvidenceCall;

typedef struct {
    int exercise, mistake_count, call_count;
    const Mistake **mistakes; // except those that only extra tests can distinguish from right
    EvidenceCall *calls;      // of all graded tests and probes, in order
} Evidence;

void evidence_begin(Evidence *evidence, int exercise, const Mistake **mistakes, int count);
void evidence_hear(Evidence *evidence, const Heard *heard, const int *nth);
void evidence_end(Evidence *evidence); // frees its contents

// Differences that the contract allows do not count: a direction is normalised if its length is
// free.
void settle_freedom(int exercise, Numbers *numbers);

// Whether two results agree within rounding. Of a step off a surface the step is compared.
bool results_agree(int exercise, const Numbers *arguments, const Numbers *a, const Numbers *b);

// Both refuse a camera, if that is right and the mistake does not show: of several reasons an
// answer may check any first.
bool refusals_agree(int exercise, const Numbers *arguments, const Numbers *yours,
                    const Numbers *theirs, const Numbers *right);

#endif
