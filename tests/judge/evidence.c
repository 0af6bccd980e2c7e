// evidence.c - the results of a wrong answer, the reference and each known mistake for every call.
#include "tests/judge/evidence.h"

#include "tests/judge/equal_numbers.h"
#include "tests/judge/record.h"
#include "tests/judge/stack_paint.h"

#include <math.h>
#include <string.h>

enum { MOST_KEPT = 40 }; // numbers of a result: any but a picture

// A ray whose direction may have any length (exercises/04-pixel-ray.h).
static bool length_is_free(int exercise)
{
    return strcmp(exercises[exercise].name, "pixel_ray") == 0;
}

void settle_freedom(int exercise, Numbers *numbers)
{
    if (!length_is_free(exercise) || numbers->count != 6)
        return;
    double *d = numbers->at + 3, length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    for (int i = 0; i < 3 && length > 0 && isfinite(length); i++)
        d[i] /= length;
}

// Sphere, point and normal are the arguments. The step off the surface is a billionth of the
// numbers, as large as the difference between two right ways to compute anything else. A thousandth
// of it is allowed between two steps.
bool results_agree(int exercise, const Numbers *arguments, const Numbers *a, const Numbers *b)
{
    enum { RADIUS = 3 };
    if (!layout_is_step(&exercises[exercise]) || a->count != 3 || b->count != 3)
        return numbers_same(a, b);
    const double *center = arguments->at;
    double size = arguments->at[RADIUS], largest = 0;
    for (int i = 0; i < 3; i++)
        largest = fmax(largest, fabs(center[i]));
    for (int i = 0; i < 3; i++)
        if (!(fabs(a->at[i] - b->at[i]) <= 0x1p-40 * (size + largest)) && a->at[i] != b->at[i])
            return false;
    return true;
}

static bool all_are_finite(const Numbers *numbers)
{
    for (int i = 0; i < numbers->count; i++)
        if (!isfinite(numbers->at[i]))
            return false;
    return true;
}

// 'Not finite' is a reason if some number is not finite; the next two are about a camera that has
// been made.
static bool may_be_a_reason(double fault, const Numbers *arguments)
{
    if (fault == CAMERA_NOT_FINITE)
        return !all_are_finite(arguments);
    return fault > CAMERA_NOT_PERPENDICULAR && fault < CAMERA_FAULTS;
}

bool refusals_agree(int exercise, const Numbers *arguments, const Numbers *yours,
                    const Numbers *theirs, const Numbers *right)
{
    if (strcmp(exercises[exercise].results, "CameraFault Camera") != 0 || yours->count < 1)
        return false;
    for (int i = 1; i < yours->count && i < right->count; i++) // *camera stays as it was
        if (!same_double(yours->at[i], right->at[i]))
            return false;
    return may_be_a_reason(yours->at[0], arguments) && theirs->at[0] != CAMERA_OK &&
           numbers_same(theirs, right);
}

static Numbers settled(int exercise, const Numbers *numbers)
{
    Numbers copy = numbers_copy(numbers);
    settle_freedom(exercise, &copy);
    return copy;
}

void evidence_begin(Evidence *evidence, int exercise, const Mistake **mistakes_of_it, int count)
{
    *evidence =
        (Evidence){.exercise = exercise, .mistake_count = count, .mistakes = mistakes_of_it};
}

static bool is_same_as_before(const Evidence *evidence, const EvidenceCall *call)
{
    bool common = false;
    for (int i = 0; i < evidence->call_count; i++) {
        EvidenceCall *other = &evidence->calls[i];
        if (other == call || !numbers_same(&other->yours, &call->yours) ||
            numbers_same(&other->arguments, &call->arguments))
            continue;
        other->is_common = common = true;
    }
    return common;
}

static void forget_if_long(Numbers *numbers)
{
    if (numbers->count > MOST_KEPT)
        numbers_free(numbers);
}

void evidence_hear(Evidence *evidence, const Heard *heard, const int *nth)
{
    int exercise = evidence->exercise;
    evidence->calls =
        realloc(evidence->calls, (size_t)(evidence->call_count + 1) * sizeof *evidence->calls);
    Theirs *theirs = calloc((size_t)evidence->mistake_count + 1, sizeof *theirs);
    if (evidence->calls == NULL || theirs == NULL)
        abort();
    EvidenceCall *call = &evidence->calls[evidence->call_count++];
    *call = (EvidenceCall){.test = record_number(),
                           .probe = record_now()->probe,
                           .arguments = numbers_copy(heard->arguments),
                           .yours = settled(exercise, heard->yours),
                           .right = settled(exercise, heard->by(exercise, NULL, -1)),
                           .theirs = theirs};
    const Numbers *given = &call->arguments;
    call->is_right = results_agree(exercise, given, &call->yours, &call->right);
    call->is_common = is_same_as_before(evidence, call);
    for (int i = 0; i < evidence->mistake_count; i++) {
        theirs[i].numbers = settled(exercise, heard->by(exercise, evidence->mistakes[i], nth[i]));
        theirs[i].is_yours =
            results_agree(exercise, given, &theirs[i].numbers, &call->yours) ||
            refusals_agree(exercise, given, &call->yours, &theirs[i].numbers, &call->right);
        theirs[i].is_right = results_agree(exercise, given, &theirs[i].numbers, &call->right);
        forget_if_long(&theirs[i].numbers);
    }
    paint_calls(OTHER_PAINT);
    call->again = settled(exercise, heard->again(exercise));
    paint_calls(PAINT);
    call->changes = !numbers_same(&call->again, &call->yours);
}

void evidence_end(Evidence *evidence)
{
    for (int i = 0; i < evidence->call_count; i++) {
        EvidenceCall *call = &evidence->calls[i];
        for (int k = 0; k < evidence->mistake_count; k++)
            numbers_free(&call->theirs[k].numbers);
        free(call->theirs);
        numbers_free(&call->arguments);
        numbers_free(&call->yours);
        numbers_free(&call->right);
        numbers_free(&call->again);
    }
    free(evidence->calls);
    *evidence = (Evidence){0};
}
