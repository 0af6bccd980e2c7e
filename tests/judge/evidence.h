// evidence.h - what a wrong answer, the reference and each known mistake made of every call.
#ifndef TESTS_JUDGE_EVIDENCE_H
#define TESTS_JUDGE_EVIDENCE_H

#include "tests/judge/suspects.h"

// What a mistake made of a call.
typedef struct {
    Numbers numbers; // none of a picture, which has too many
    bool is_yours, is_right;
} Theirs;

typedef struct {
    int test;   // its number in the run
    bool probe; // of general inputs; a test may have special ones
    Numbers arguments, yours, right, again;
    bool is_right;  // yours is
    bool is_common; // yours is the same as for other arguments: NO_HIT, say, or 0
    bool changes;   // asked again, yours was another
    Theirs *theirs; // of each mistake
} EvidenceCall;

typedef struct {
    int exercise, mistake_count, call_count;
    const Mistake **mistakes; // but those that only extra tests can tell from right
    EvidenceCall *calls;      // of all graded tests and probes, in order
} Evidence;

void evidence_begin(Evidence *evidence, int exercise, const Mistake **mistakes, int count);
void evidence_hear(Evidence *evidence, const Heard *heard, const int *nth);
void evidence_end(Evidence *evidence); // frees what it holds

// What is free by the contract does not count: a direction is made unit where its length is.
void settle_freedom(int exercise, Numbers *numbers);

// Whether two results agree as far as anybody can tell. Of a step off a surface that is the step.
bool results_agree(int exercise, const Numbers *arguments, const Numbers *a, const Numbers *b);

// Both refuse a camera, where that is right and the mistake does not show: of several reasons any
// may be looked for first.
bool refusals_agree(int exercise, const Numbers *arguments, const Numbers *yours,
                    const Numbers *theirs, const Numbers *right);

#endif
