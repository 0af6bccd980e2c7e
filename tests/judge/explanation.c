// explanation.c - what a wrong answer is that is no known mistake by itself.
#include "tests/judge/explanation.h"

#include <math.h>
#include <stdio.h>

enum { ENOUGH = 3 }; // general inputs that speak for a mistake

// Where the mistake shows, the answer never is right, or it does not make that mistake.
static bool is_contradicted(const Evidence *evidence, int mistake)
{
    for (int i = 0; i < evidence->call_count; i++)
        if (evidence->calls[i].is_right && !evidence->calls[i].theirs[mistake].is_right)
            return true;
    return false;
}

// The answer does what the mistake does, and what comes out cannot be by chance: no NO_HIT, 0 or
// the like, which many mistakes return for many inputs.
static bool speaks_for(const EvidenceCall *call, int mistake)
{
    return call->probe && !call->is_common && !call->is_right && call->theirs[mistake].is_yours;
}

static bool speaks_for_nobody_else(const EvidenceCall *call, int mistake, int count,
                                   const bool *possible)
{
    for (int i = 0; i < count; i++)
        if (i != mistake && possible[i] && call->theirs[i].is_yours)
            return false;
    return true;
}

static Diagnosis in_part(const Evidence *evidence, int shown)
{
    int count = evidence->mistake_count, most = 0;
    Diagnosis it = {0};
    bool *possible = calloc((size_t)count + 1, sizeof *possible);
    if (possible == NULL)
        abort();
    for (int i = 0; i < count; i++)
        possible[i] = !is_contradicted(evidence, i) &&
                      (shown < 0 || evidence->calls[shown].theirs[i].is_yours);
    for (int i = 0; i < count; i++) {
        int speaking = 0;
        for (int k = 0; possible[i] && k < evidence->call_count; k++)
            speaking += speaks_for(&evidence->calls[k], i) &&
                        speaks_for_nobody_else(&evidence->calls[k], i, count, possible);
        if (speaking == most)
            it = (Diagnosis){0};
        if (speaking >= ENOUGH && speaking > most)
            it = (Diagnosis){.mistake = evidence->mistakes[i], .in_part = true};
        most = speaking > most ? speaking : most;
    }
    free(possible);
    return it;
}

Diagnosis explain_by_evidence(const Evidence *evidence, int shown, bool hidden)
{
    (void)hidden;
    return in_part(evidence, shown);
}
