// explanation.c - explains a wrong answer that is not simply one known mistake.
#include "tests/judge/explanation.h"

#include "tests/judge/equal_numbers.h"
#include "tests/judge/stack_paint.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ENOUGH = 3 }; // general inputs that support a mistake

// Excluded: on a call where the mistake is wrong, the answer is right.
static bool is_contradicted(const Evidence *evidence, int mistake)
{
    for (int i = 0; i < evidence->call_count; i++)
        if (evidence->calls[i].is_right && !evidence->calls[i].theirs[mistake].is_right)
            return true;
    return false;
}

// By more than the last digits, which depend on how a formula is computed.
static bool is_clearly_wrong(const EvidenceCall *call)
{
    for (int i = 0; i < call->yours.count && i < call->right.count; i++) {
        double yours = call->yours.at[i], right = call->right.at[i];
        if (!(fabs(yours - right) <= 1e-4 * (1e-9 + fmin(fabs(yours), fabs(right)))))
            return true;
    }
    return false;
}

// The answer returns the same as the mistake, and not by chance: not NO_HIT, 0 or another value
// that many mistakes return for many inputs.
static bool speaks_for(const EvidenceCall *call, int mistake)
{
    return is_clearly_wrong(call) && call->probe && !call->is_common && !call->is_right &&
           call->theirs[mistake].is_yours;
}

static bool speaks_for_nobody_else(const EvidenceCall *call, int mistake, int count,
                                   const bool *possible)
{
    for (int i = 0; i < count; i++)
        if (i != mistake && possible[i] && call->theirs[i].is_yours)
            return false;
    return true;
}

// At least one number that the mistake gets wrong has the same value in the answer.
static bool is_like(const EvidenceCall *call, int mistake)
{
    const Numbers *theirs = &call->theirs[mistake].numbers;
    bool like = call->theirs[mistake].is_yours;
    for (int i = 0; i < theirs->count && i < call->yours.count && i < call->right.count; i++)
        like = like || (!same_double(theirs->at[i], call->right.at[i]) &&
                        same_double(theirs->at[i], call->yours.at[i]));
    return like;
}

// Of the general inputs on which the mistake is wrong, the answer agrees with it on most, and on
// none it has something quite different: an answer that computes a term in a wrong way has none of
// it on many inputs, but did not leave it out. And these inputs are most of those on which the
// answer is wrong.
static bool is_usual(const Evidence *evidence, int mistake)
{
    int same = 0, shows = 0, wrong = 0;
    for (int i = 0; i < evidence->call_count; i++) {
        const EvidenceCall *call = &evidence->calls[i];
        if (!call->probe)
            continue;
        wrong += !call->is_right;
        if (call->theirs[mistake].is_right)
            continue;
        shows++;
        same += call->theirs[mistake].is_yours;
        if (!is_like(call, mistake))
            return false;
    }
    return 2 * same > shows && 2 * same > wrong;
}

// The only mistake that any input supports.
static Diagnosis in_part(const Evidence *evidence, int shown)
{
    int count = evidence->mistake_count, found = -1, others = 0;
    bool *possible = calloc((size_t)count + 1, sizeof *possible);
    if (possible == NULL)
        abort();
    for (int i = 0; i < count; i++)
        possible[i] = !is_contradicted(evidence, i);
    for (int i = 0; i < count; i++) {
        int speaking = 0;
        for (int k = 0; possible[i] && k < evidence->call_count; k++)
            speaking += speaks_for(&evidence->calls[k], i) &&
                        speaks_for_nobody_else(&evidence->calls[k], i, count, possible);
        if (speaking >= ENOUGH && found < 0)
            found = i;
        else
            others += speaking > 0;
    }
    free(possible);
    if (found < 0 || others > 0 || !is_usual(evidence, found) ||
        (shown >= 0 && !evidence->calls[shown].theirs[found].is_yours))
        return (Diagnosis){0};
    return (Diagnosis){.mistake = evidence->mistakes[found], .in_part = true};
}

// ---- two mistakes -------------------------------------------------------------------------------

// If one mistake is right in a number, that number is the other mistake's; if both are wrong, their
// errors are added. Errors that partly cancel are another mistake: (1 - kd) is not kd left out and
// the whole left out as well.
static bool is_sum(const EvidenceCall *call, const Numbers *one, const Numbers *other)
{
    const Numbers *yours = &call->yours, *right = &call->right;
    double along = 0; // the one error times the other
    if (one->count != yours->count || other->count != yours->count || right->count != yours->count)
        return false;
    for (int i = 0; i < yours->count; i++) {
        double a = one->at[i], b = other->at[i], r = right->at[i];
        double sum = same_double(a, r) ? b : same_double(b, r) ? a : a + b - r;
        if (!same_double(yours->at[i], sum))
            return false;
        along += same_double(a, r) || same_double(b, r) ? 0 : (a - r) * (b - r);
    }
    return !(along < -1e-9);
}

static bool may_be_both(const EvidenceCall *call, int one, int other)
{
    const Theirs *a = &call->theirs[one], *b = &call->theirs[other];
    if (a->is_right)
        return b->is_yours;
    if (b->is_right || (a->is_yours && b->is_yours))
        return a->is_yours;
    return is_sum(call, &a->numbers, &b->numbers);
}

// In space, if the two errors have different directions: then they add up to this error only by
// chance.
static bool errors_differ(const EvidenceCall *call, int mistake, int other)
{
    const Numbers *one = &call->theirs[mistake].numbers, *two = &call->theirs[other].numbers;
    double ee = 0, ef = 0, ff = 0;
    for (int i = 0; i < call->right.count; i++) {
        double e = one->at[i] - call->right.at[i], f = two->at[i] - call->right.at[i];
        ee += e * e;
        ef += e * f;
        ff += f * f;
    }
    return call->right.count >= 3 && ee * ff - ef * ef > 1e-6 * ee * ff;
}

// The answer needs this mistake: one of its numbers is the mistake's, and the other mistake is
// right there; or both are wrong. If the errors of both are equal, sums mean nothing.
static bool is_needed(const EvidenceCall *call, int mistake, int other)
{
    const Theirs *a = &call->theirs[mistake], *b = &call->theirs[other];
    const Numbers *yours = &call->yours, *right = &call->right;
    if (a->is_right || b->is_yours)
        return false;
    if (b->is_right)
        return a->is_yours;
    if (a->numbers.count != right->count || b->numbers.count != right->count)
        return false;
    for (int i = 0; i < right->count && i < yours->count; i++)
        if (same_double(b->numbers.at[i], right->at[i]) &&
            !same_double(a->numbers.at[i], right->at[i]) &&
            same_double(yours->at[i], a->numbers.at[i]))
            return true;
    return errors_differ(call, mistake, other);
}

// The number of general inputs on which the other mistake alone does not give the answer, but this
// one does: all of them, and those on which the agreement cannot be by chance.
static void count_needed(const Evidence *evidence, int mistake, int other, int *all, int *telling)
{
    *all = *telling = 0;
    for (int i = 0; i < evidence->call_count; i++) {
        const EvidenceCall *call = &evidence->calls[i];
        if (!call->probe || !is_needed(call, mistake, other))
            continue;
        ++*all;
        *telling += !call->is_common;
    }
}

static bool are_both(const Evidence *evidence, int one, int other)
{
    int first, second, first_telling, second_telling;
    for (int i = 0; i < evidence->call_count; i++)
        if (!may_be_both(&evidence->calls[i], one, other))
            return false;
    count_needed(evidence, one, other, &first, &first_telling);
    count_needed(evidence, other, one, &second, &second_telling);
    return first >= ENOUGH && second >= ENOUGH &&
           (first_telling >= ENOUGH || second_telling >= ENOUGH);
}

// The only two that together explain every call; none if another pair does. For pictures too little
// is kept to decide, and steps off a surface are too small to be added up.
static Diagnosis two_at_once(const Evidence *evidence)
{
    Diagnosis it = {0};
    const Exercise *exercise = &exercises[evidence->exercise];
    if (strncmp(exercise->results, "Pixels", 6) == 0 || layout_is_step(exercise))
        return it;
    for (int i = 0; i < evidence->mistake_count; i++)
        for (int k = i + 1; k < evidence->mistake_count; k++) {
            if (!are_both(evidence, i, k))
                continue;
            if (it.mistake != NULL)
                return (Diagnosis){0};
            it = (Diagnosis){
                .mistake = evidence->mistakes[i], .other = evidence->mistakes[k], .also = true};
        }
    return it;
}

// ---- wrong answers that no formula explains -----------------------------------------------------

// The positions of the numbers in a result that were never written: the stack's old contents were
// returned.
static bool is_unset(const Evidence *evidence, int place)
{
    int unset = 0;
    for (int i = 0; i < evidence->call_count; i++) {
        const EvidenceCall *call = &evidence->calls[i];
        unset += place < call->yours.count && place < call->again.count &&
                 is_paint(call->yours.at[place], PAINT) &&
                 is_paint(call->again.at[place], OTHER_PAINT);
    }
    return unset > 0;
}

// The camera that a function had to store in *camera, if part of the old one is still there: in all
// calls that returned a camera.
static bool is_left_as_it_was(const Evidence *evidence, int place)
{
    int left = 0;
    for (int i = 0; i < evidence->call_count; i++) {
        const EvidenceCall *call = &evidence->calls[i];
        if (call->yours.at[0] != CAMERA_OK || call->right.at[0] != CAMERA_OK)
            continue;
        double before = call->arguments.at[call->arguments.count - call->yours.count + place];
        if (!same_double(call->yours.at[place], before))
            return false;
        left += !same_double(call->right.at[place], before);
    }
    return left >= ENOUGH;
}

typedef bool IsSo(const Evidence *evidence, int place);

// The fields of a result for which that is true, in words; "" if there are none.
static const char *fields_that(const Evidence *evidence, IsSo *is_so)
{
    static char words[200];
    const char *last = "";
    const char *results = exercises[evidence->exercise].results;
    words[0] = '\0';
    for (int i = 0; i < layout_places(results); i++) {
        const char *name = layout_place(results, i);
        if (!is_so(evidence, i) || strcmp(name, last) == 0)
            continue;
        size_t used = strlen(words);
        snprintf(words + used, sizeof words - used, "%s%s", used > 0 ? ", " : "",
                 name[0] != '\0' ? name : "the result");
        last = name;
    }
    return words;
}

static const char *what_was_not_set(const Evidence *evidence)
{
    static char words[400];
    const char *results = exercises[evidence->exercise].results;
    const char *unset = fields_that(evidence, is_unset);
    if (unset[0] != '\0') {
        snprintf(words, sizeof words,
                 "%s was never set: your function returns a value that happened to be in memory",
                 unset);
        return words;
    }
    if (strcmp(results, "CameraFault Camera") != 0)
        return NULL;
    unset = fields_that(evidence, is_left_as_it_was);
    if (unset[0] == '\0')
        return NULL;
    snprintf(words, sizeof words,
             "%s of *camera was never set: it is still as it was before the call", unset);
    return words;
}

static const char *what_changes(const Evidence *evidence, bool changed_since)
{
    for (int i = 0; i < evidence->call_count; i++)
        if (changed_since || evidence->calls[i].changes)
            return "your function gives another result when it is called again with the same "
                   "arguments: it keeps a value between calls (in a static or global variable?), "
                   "uses a variable that was never set, or reads past the end of an array";
    return NULL;
}

// ---- answers that ignore their arguments --------------------------------------------------------

enum { MANY = 8 }; // calls

static bool is_always_the_same(const Evidence *evidence, int places)
{
    for (int i = 1; i < evidence->call_count; i++) {
        const double *first = evidence->calls[0].yours.at, *yours = evidence->calls[i].yours.at;
        for (int k = 0; k < places; k++)
            if (evidence->calls[i].yours.count < places || !same_double(first[k], yours[k]))
                return false;
    }
    return evidence->call_count >= MANY;
}

// Whether all numbers of the result are those of the arguments that start there.
static bool is_argument(const Evidence *evidence, int from)
{
    for (int i = 0; i < evidence->call_count; i++) {
        const EvidenceCall *call = &evidence->calls[i];
        if (call->arguments.count < from + call->yours.count)
            return false;
        for (int k = 0; k < call->yours.count; k++)
            if (!same_double(call->arguments.at[from + k], call->yours.at[k]))
                return false;
    }
    return evidence->call_count >= MANY;
}

// In every call the whole picture has the colour of its first pixel.
static bool is_one_color(const Evidence *evidence, bool has_depth)
{
    for (int i = 0; i < evidence->call_count; i++) {
        const Numbers *yours = &evidence->calls[i].yours;
        int bytes = has_depth ? yours->count / 4 * 3 : yours->count;
        for (int k = 3; k < bytes; k++)
            if (yours->at[k] != yours->at[k % 3])
                return false;
    }
    return evidence->call_count >= MANY;
}

static const char *what_is_trivial(const Evidence *evidence)
{
    static char words[300];
    const char *results = exercises[evidence->exercise].results;
    if (evidence->call_count == 0)
        return NULL;
    const Numbers *yours = &evidence->calls[0].yours;
    if (strncmp(results, "Pixels", 6) == 0)
        return is_one_color(evidence, strcmp(results, "Pixels") != 0)
                   ? "every pixel of your picture has the same colour, whatever is in the scene"
                   : NULL;
    if (strncmp(results, "CameraFault", 11) == 0) {
        int fault = (int)yours->at[0];
        if (fault <= CAMERA_OK || fault >= CAMERA_FAULTS || !is_always_the_same(evidence, 1))
            return NULL;
        snprintf(words, sizeof words,
                 "your function refuses all arguments, always for the same reason: %s",
                 camera_fault_text((CameraFault)fault));
        return words;
    }
    if (is_always_the_same(evidence, yours->count))
        return "your function returns the same result in every call, whatever its arguments are";
    for (int from = 0; from < evidence->calls[0].arguments.count; from++)
        if (is_argument(evidence, from))
            return "your function returns one of its arguments unchanged";
    return NULL;
}

// These words contain no number of a test, so that they may also be shown for hidden tests.
Diagnosis explain_by_evidence(const Evidence *evidence, int shown, bool changed_since)
{
    const char *words = what_was_not_set(evidence);
    if (words == NULL)
        words = what_changes(evidence, changed_since);
    if (words == NULL)
        words = what_is_trivial(evidence);
    if (words != NULL)
        return (Diagnosis){.law = words};
    Diagnosis both = two_at_once(evidence);
    return both.mistake != NULL ? both : in_part(evidence, shown);
}
