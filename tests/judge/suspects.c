// suspects.c - which known mistake a wrong answer is, and which law it breaks.
#include "tests/judge/suspects.h"

#include "tests/judge/known.h"
#include "tests/judge/message.h"
#include "tests/judge/runner.h"
#include "tests/judge/table.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

// ---- explains a wrong answer that is not simply one known mistake ------------------------------

// It is better to say nothing than something false. So a mistake is named only if the answer agrees
// with it on several general inputs, and is never right where the mistake is wrong. Two are named
// together if they explain every call.

// The result of a mistake for a call.
typedef struct {
    Numbers numbers; // none for a picture, which has too many
    bool is_yours, is_right;
} Theirs;

typedef struct {
    int test;         // its number in the run
    const char *name; // and its name
    bool extra;       // it costs no marks
    bool probe;       // with general arguments; a test may have special ones
    Numbers arguments, yours, right, again;
    bool is_right;  // yours is
    bool is_common; // yours is the same as for other arguments: NO_HIT, say, or 0
    bool changes;   // called again with other paint, yours returned something else
    bool repeats;   // and with the same paint it returned the same
    bool is_padded; // yours depends on the padding
    Theirs *theirs; // of each mistake
} EvidenceCall;

enum { MOST_MISTAKES = 100 };
static struct {
    int exercise, mistake_count, call_count;
    const Mistake *mistakes[MOST_MISTAKES];
    int nth[MOST_MISTAKES];        // among all mistakes of the exercise
    bool ruled_out[MOST_MISTAKES]; // a call was answered in another way
    EvidenceCall *calls;           // of tests and probes, in order
    // Each call is repeated. Then extra tests do not count, nor do the mistakes that only they can
    // distinguish from right.
    bool is_close;
} evidence;

static const EvidenceCall *end_of_calls(void)
{
    return evidence.calls + evidence.call_count;
}

// ---- evidence ----------------------------------------------------------------------------------

enum { MOST_KEPT = 40 }; // numbers of a result: any but a picture

// As long as the reference's, if the contract of offset_from_surface allows its length. The step is
// a billionth of the numbers, as large as the difference between two right ways to compute anything
// else.
static double size_of_sphere(const Numbers *arguments)
{
    enum { RADIUS = 3 };
    double largest = 0;
    for (int i = 0; i < RADIUS; i++)
        largest = fmax(largest, fabs(arguments->at[i]));
    return arguments->at[RADIUS] + largest;
}

static void settle_step(const Numbers *arguments, Numbers *numbers)
{
    const double *from = arguments->at + STEP_FROM;
    double *to = numbers->at, size = size_of_sphere(arguments), length = 0;
    for (int i = 0; i < 3; i++)
        length = hypot(length, to[i] - from[i]);
    if (length < 0.99 * 0x1p-32 * size || length > 1.01 * 0x1p-28 * size)
        return;
    for (int i = 0; i < 3; i++)
        to[i] = from[i] + 0x1p-30 * size / length * (to[i] - from[i]);
}

// Differences that the contract allows do not count: a direction is normalised if its length is
// free, and so is a step off a surface.
static void settle_freedom(const Numbers *arguments, Numbers *numbers)
{
    if (layout_is_step(&exercises[evidence.exercise]) && numbers->count == 3)
        settle_step(arguments, numbers);
    if (!question_now()->length_is_free || numbers->count != 6)
        return;
    double *d = numbers->at + 3, length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    for (int i = 0; i < 3 && length > 0 && isfinite(length); i++)
        d[i] /= length;
}

// A thousandth of a step is allowed between two steps.
static bool steps_agree(const Numbers *arguments, const Numbers *a, const Numbers *b)
{
    double tolerance = 0x1p-40 * size_of_sphere(arguments);
    for (int i = 0; i < 3; i++)
        if (!(fabs(a->at[i] - b->at[i]) <= tolerance) && a->at[i] != b->at[i])
            return false;
    return true;
}

// The image in a curved mirror depends a little on the length of the step off it.
static double rounding(void)
{
    return strcmp(exercises[evidence.exercise].name, "trace_ray") == 0 ? 3e-9 : 1e-9;
}

// Whether two results agree within rounding. Of a step off a surface the step is compared, of
// refusals for one of several reasons (numbers.h) one reason must be the same.
static bool results_agree(const Numbers *arguments, const Numbers *a, const Numbers *b)
{
    bool have_reason = has_reasons(evidence.exercise) && (reasons_in(a) & reasons_in(b)) != 0;
    if (layout_is_step(&exercises[evidence.exercise]) && a->count == 3 && b->count == 3)
        return steps_agree(arguments, a, b);
    bool same = a->count == b->count;
    for (int i = have_reason ? 1 : 0; same && i < a->count; i++)
        same = same_within(a->at[i], b->at[i], rounding());
    return same;
}

// Whether a call says nothing against the mistake: the answer agrees with it, or both are right,
// each as it uses the freedom of the contract. All three are settled.
static bool may_be_mistake(const Numbers *arguments, const Numbers *yours, const Numbers *theirs,
                           const Numbers *right)
{
    return results_agree(arguments, yours, theirs) ||
           (results_agree(arguments, yours, right) && results_agree(arguments, theirs, right));
}

static Numbers settled(const Numbers *arguments, const Numbers *numbers)
{
    Numbers copy = numbers_copy(numbers);
    settle_freedom(arguments, &copy);
    return copy;
}

// One of several reasons: the other's, if it is among them.
static void settle_reason(Numbers *numbers, const Numbers *other)
{
    int reasons = reasons_in(numbers), both = reasons & reasons_in(other);
    int among = both != 0 ? both : reasons;
    if (has_reasons(evidence.exercise) && among != 0)
        set_reasons(numbers, among & -among);
}

static bool is_same_as_before(const EvidenceCall *call)
{
    bool common = false;
    for (EvidenceCall *other = evidence.calls; other < end_of_calls(); other++) {
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

static Numbers called_again(const Numbers *arguments, int paint)
{
    paint_calls(paint);
    Numbers numbers = settled(arguments, ask_again(evidence.exercise));
    paint_calls(PAINT);
    return numbers;
}

static bool is_repeated(const EvidenceCall *call, int paint)
{
    Numbers again = called_again(&call->arguments, paint);
    bool same = numbers_same(&again, &call->yours);
    numbers_free(&again);
    return same;
}

// Only the last digits differ: only extra tests can distinguish it from right.
static bool is_of_digits(const Mistake *mistake)
{
    return strncmp(mistake->id, "X-", 2) == 0;
}

static void repeat(EvidenceCall *call)
{
    call->is_common = is_same_as_before(call);
    call->again = called_again(&call->arguments, OTHER_PAINT);
    bool is_same_if_0 = is_repeated(call, EMPTY_STACK);
    call->changes = !numbers_same(&call->again, &call->yours) || !is_same_if_0;
    call->repeats = is_repeated(call, PAINT);
    call->is_padded = !is_repeated(call, PAINT | EMPTY_PADDING) ||
                      (!is_same_if_0 && is_repeated(call, EMPTY_STACK | EMPTY_PADDING));
}

static void evidence_hear(const Numbers *given, const Numbers *yours)
{
    int exercise = evidence.exercise;
    evidence.calls =
        realloc(evidence.calls, (size_t)(evidence.call_count + 1) * sizeof *evidence.calls);
    Theirs *theirs = calloc((size_t)evidence.mistake_count + 1, sizeof *theirs);
    if (evidence.calls == NULL || theirs == NULL)
        abort();
    EvidenceCall *call = &evidence.calls[evidence.call_count++];
    Numbers right = settled(given, known_result(exercise, -1));
    *call = (EvidenceCall){.test = record_number(),
                           .name = record_now()->name,
                           .extra = record_now()->extra,
                           .probe = record_now()->probe,
                           .arguments = numbers_copy(given),
                           .yours = settled(given, yours),
                           .right = numbers_copy(&right),
                           .theirs = theirs};
    call->is_right = results_agree(given, &call->yours, &right);
    settle_reason(&call->right, &call->yours);
    for (int i = 0; i < evidence.mistake_count; i++) {
        Numbers *numbers = &theirs[i].numbers;
        if (evidence.ruled_out[i] && !evidence.is_close)
            continue;
        *numbers = settled(given, known_result(exercise, evidence.nth[i]));
        theirs[i].is_yours = may_be_mistake(given, &call->yours, numbers, &right);
        theirs[i].is_right = results_agree(given, numbers, &right);
        settle_reason(numbers, &call->right);
        settle_reason(numbers, &call->yours);
        forget_if_long(numbers);
        // On the extreme inputs of extra tests every way to arrange a formula has its own digits.
        if (!theirs[i].is_yours && (!call->extra || is_of_digits(evidence.mistakes[i])))
            evidence.ruled_out[i] = true;
    }
    numbers_free(&right);
    if (evidence.is_close)
        repeat(call);
}

// frees its contents
static void evidence_end(void)
{
    for (EvidenceCall *call = evidence.calls; call < end_of_calls(); call++) {
        for (int k = 0; k < evidence.mistake_count; k++)
            numbers_free(&call->theirs[k].numbers);
        free(call->theirs);
        numbers_free(&call->arguments);
        numbers_free(&call->yours);
        numbers_free(&call->right);
        numbers_free(&call->again);
    }
    free(evidence.calls);
    memset(&evidence, 0, sizeof evidence);
}

enum { ENOUGH = 3 }; // general inputs that support a mistake

// Excluded: on a call where the mistake is wrong, the answer is right.
static bool is_contradicted(int mistake)
{
    for (const EvidenceCall *call = evidence.calls; call < end_of_calls(); call++)
        if (call->is_right && !call->theirs[mistake].is_right)
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

static bool speaks_for_nobody_else(const EvidenceCall *call, int mistake, const bool *possible)
{
    for (int i = 0; i < evidence.mistake_count; i++)
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
static bool is_usual(int mistake)
{
    int same = 0, shows = 0, wrong = 0;
    for (const EvidenceCall *call = evidence.calls; call < end_of_calls(); call++) {
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
static Diagnosis in_part(int shown)
{
    int found = -1, others = 0;
    bool possible[MOST_MISTAKES];
    for (int i = 0; i < evidence.mistake_count; i++)
        possible[i] = !is_contradicted(i);
    for (int i = 0; i < evidence.mistake_count; i++) {
        int speaking = 0;
        for (const EvidenceCall *call = evidence.calls; possible[i] && call < end_of_calls();
             call++)
            speaking += speaks_for(call, i) && speaks_for_nobody_else(call, i, possible);
        if (speaking >= ENOUGH && found < 0)
            found = i;
        else
            others += speaking > 0;
    }
    if (found < 0 || others > 0 || !is_usual(found) ||
        (shown >= 0 && !evidence.calls[shown].theirs[found].is_yours))
        return (Diagnosis){0};
    return (Diagnosis){.mistake = evidence.mistakes[found], .in_part = true};
}

// ---- two mistakes ------------------------------------------------------------------------------

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
static void count_needed(int mistake, int other, int *all, int *telling)
{
    *all = *telling = 0;
    for (const EvidenceCall *call = evidence.calls; call < end_of_calls(); call++) {
        if (!call->probe || !is_needed(call, mistake, other))
            continue;
        ++*all;
        *telling += !call->is_common;
    }
}

static bool are_both(int one, int other)
{
    int first, second, first_telling, second_telling;
    for (const EvidenceCall *call = evidence.calls; call < end_of_calls(); call++)
        if (!may_be_both(call, one, other))
            return false;
    count_needed(one, other, &first, &first_telling);
    count_needed(other, one, &second, &second_telling);
    return first >= ENOUGH && second >= ENOUGH &&
           (first_telling >= ENOUGH || second_telling >= ENOUGH);
}

// The only two that together explain every call; none if another pair does. For pictures too little
// is kept to decide, and steps off a surface are too small to be added up.
static Diagnosis two_at_once(void)
{
    Diagnosis it = {0};
    const Exercise *exercise = &exercises[evidence.exercise];
    if (strncmp(exercise->results, "Pixels", 6) == 0 || layout_is_step(exercise))
        return it;
    for (int i = 0; i < evidence.mistake_count; i++)
        for (int k = i + 1; k < evidence.mistake_count; k++) {
            if (!are_both(i, k))
                continue;
            if (it.mistake != NULL)
                return (Diagnosis){0};
            it = (Diagnosis){
                .mistake = evidence.mistakes[i], .other = evidence.mistakes[k], .also = true};
        }
    return it;
}

// ---- wrong answers that no formula explains ----------------------------------------------------

// The positions of the numbers in a result that were never written: the stack's old contents were
// returned.
static bool is_unset(int place)
{
    int unset = 0;
    for (const EvidenceCall *call = evidence.calls; call < end_of_calls(); call++) {
        unset += place < call->yours.count && place < call->again.count &&
                 is_paint(call->yours.at[place], PAINT) &&
                 is_paint(call->again.at[place], OTHER_PAINT);
    }
    return unset > 0;
}

// The camera that a function had to store in *camera, if part of the old one is still there: in all
// calls that returned a camera.
static bool is_left_as_it_was(int place)
{
    int left = 0;
    for (const EvidenceCall *call = evidence.calls; call < end_of_calls(); call++) {
        if (call->yours.at[0] != CAMERA_OK || call->right.at[0] != CAMERA_OK)
            continue;
        double before = call->arguments.at[call->arguments.count - call->yours.count + place];
        if (!same_double(call->yours.at[place], before))
            return false;
        left += !same_double(call->right.at[place], before);
    }
    return left >= ENOUGH;
}

typedef bool IsSo(int place);

// The fields of a result for which that is true, in words; "" if there are none.
static const char *fields_that(IsSo *is_so)
{
    static char words[200];
    const char *last = NULL;
    const char *names[MOST_PLACES];
    int count = layout_names(exercises[evidence.exercise].results, names);
    words[0] = '\0';
    for (int i = 0; i < count; i++) {
        if (!is_so(i) || (last != NULL && strcmp(names[i], last) == 0))
            continue;
        size_t used = strlen(words);
        snprintf(words + used, sizeof words - used, "%s%s", used > 0 ? ", " : "",
                 names[i][0] != '\0' ? names[i] : "the result");
        last = names[i];
    }
    return words;
}

static const char *one_or_several(const char *fields, const char *one, const char *several)
{
    return strchr(fields, ',') != NULL ? several : one;
}

static const char *what_was_not_set(void)
{
    static char words[400];
    const char *unset = fields_that(is_unset);
    bool is_left = unset[0] == '\0' && has_reasons(evidence.exercise);
    if (is_left)
        unset = fields_that(is_left_as_it_was);
    if (unset[0] == '\0')
        return NULL;
    snprintf(words, sizeof words, "%s%s %s never set: %s", unset, is_left ? " of *camera" : "",
             one_or_several(unset, "was", "were"),
             is_left ? "still as before the call"
                     : "your function uses what happened to be in memory");
    return words;
}

// A result that depends on the fourth lane of a vec3. Other padding of an argument has no name.
static const char *what_uses_padding(void)
{
    for (const EvidenceCall *call = evidence.calls; call < end_of_calls(); call++) {
        if (call->repeats && call->is_padded)
            return "your function uses v[3] of a vec3, which is not part of the vector "
                   "(common/vec3.h): a loop over its components ends after v[2]";
    }
    return NULL;
}

// All numbers of the field that a place belongs to, in every call that returned a result.
static bool is_always_0(int place)
{
    const char *names[MOST_PLACES];
    int differs = 0, count = layout_names(exercises[evidence.exercise].results, names);
    for (int i = 0; i < count; i++)
        for (const EvidenceCall *call = evidence.calls;
             call < end_of_calls() && strcmp(names[i], names[place]) == 0; call++) {
            if (has_reasons(evidence.exercise) &&
                (call->yours.at[0] != CAMERA_OK || call->right.at[0] != CAMERA_OK))
                continue;
            if (i >= call->yours.count || i >= call->right.count || call->yours.at[i] != 0)
                return false;
            differs += call->right.at[i] != 0;
        }
    return names[place][0] != '\0' && differs >= ENOUGH;
}

static const char *what_is_0(void)
{
    static char words[400];
    const char *fields = fields_that(is_always_0);
    if (fields[0] == '\0')
        return NULL;
    snprintf(words, sizeof words, "%s %s 0 in every call: does your function set %s?", fields,
             one_or_several(fields, "is", "are"), one_or_several(fields, "it", "them"));
    return words;
}

static const char *what_changes(bool changed_since)
{
    for (const EvidenceCall *call = evidence.calls; call < end_of_calls(); call++)
        if (call->changes && call->repeats)
            return "your function uses a variable that was never set, and so what happened to be "
                   "in memory";
    for (const EvidenceCall *call = evidence.calls; call < end_of_calls(); call++)
        if (changed_since || call->changes)
            return "your function gives another result when it is called again with the same "
                   "arguments: it keeps a value between calls (in a static or global variable?), "
                   "uses a variable that was never set, or reads past the end of an array";
    return NULL;
}

// ---- answers that ignore their arguments -------------------------------------------------------

enum { MANY = 8 }; // calls

static bool is_always_the_same(void)
{
    for (const EvidenceCall *call = evidence.calls; call < end_of_calls(); call++)
        if (!numbers_same(&evidence.calls[0].yours, &call->yours))
            return false;
    return evidence.call_count >= MANY;
}

// Whether all numbers of the result are those of the arguments that start there.
static bool is_argument(int from)
{
    for (const EvidenceCall *call = evidence.calls; call < end_of_calls(); call++) {
        const Numbers *arguments = &call->arguments, *yours = &call->yours;
        const Numbers part = {.count = yours->count, .at = arguments->at + from};
        if (arguments->count < from + yours->count || !numbers_same(&part, yours))
            return false;
    }
    return evidence.call_count >= MANY;
}

// In every call the whole picture has the color of its first pixel.
static bool is_one_color(bool has_depth)
{
    for (const EvidenceCall *call = evidence.calls; call < end_of_calls(); call++) {
        const Numbers *yours = &call->yours;
        int bytes = has_depth ? yours->count / 4 * 3 : yours->count;
        for (int k = 3; k < bytes; k++)
            if (yours->at[k] != yours->at[k % 3])
                return false;
    }
    return evidence.call_count >= MANY;
}

// Of a function that may refuse: the reason for which it did so in every call; CAMERA_OK: none.
static CameraFault one_refusal(void)
{
    if (!has_reasons(evidence.exercise))
        return CAMERA_OK;
    for (const EvidenceCall *call = evidence.calls; call < end_of_calls(); call++)
        if (call->yours.at[0] != evidence.calls[0].yours.at[0])
            return CAMERA_OK;
    return evidence.call_count > 0 ? (CameraFault)evidence.calls[0].yours.at[0] : CAMERA_OK;
}

static const char *what_is_trivial(void)
{
    static char words[300];
    const char *results = exercises[evidence.exercise].results;
    if (strncmp(results, "Pixels", 6) == 0)
        return is_one_color(strcmp(results, "Pixels") != 0)
                   ? "every pixel of your picture has the same color, whatever is in the scene"
                   : NULL;
    if (has_reasons(evidence.exercise)) {
        CameraFault fault = one_refusal();
        if (fault <= CAMERA_OK || fault >= CAMERA_FAULTS || evidence.call_count < MANY)
            return NULL;
        snprintf(words, sizeof words,
                 "your function refuses all arguments, always for the same reason: %s",
                 camera_fault_text(fault));
        return words;
    }
    if (is_always_the_same())
        return "your function returns the same result in every call, whatever its arguments are";
    for (int from = 0; evidence.call_count > 0 && from < evidence.calls[0].arguments.count; from++)
        if (is_argument(from))
            return "your function returns one of its arguments unchanged";
    return NULL;
}

// ---- rounding, and float -----------------------------------------------------------------------

// Differs from the right result, but by so little that a float may be the reason: a step off a
// surface is that small, so all of the point must be floats.
static bool is_off_by_a_float(const EvidenceCall *call)
{
    bool is_step = layout_is_step(&exercises[evidence.exercise]);
    if (call->is_right || call->yours.count != call->right.count)
        return false;
    for (int i = 0; i < call->right.count; i++) {
        double yours = call->yours.at[i], right = call->right.at[i];
        bool is_near =
            yours == right || fabs(yours - right) <= 1e-5 * (1 + fmin(fabs(yours), fabs(right)));
        if (!is_near || (is_step && yours != (double)(float)yours))
            return false;
    }
    return true;
}

// A float in its place would be wrong.
static bool needs_a_double(const EvidenceCall *call)
{
    for (int i = 0; i < call->right.count; i++)
        if (!same_double(call->right.at[i], (float)call->right.at[i]))
            return true;
    return false;
}

// Most of what is wrong is off by so little, and most results that no float holds are wrong: a
// special case or a limit is wrong only here and there.
static const char *what_is_a_float(void)
{
    int wrong = 0, off = 0, shows = 0, shown = 0;
    for (const EvidenceCall *call = evidence.calls; call < end_of_calls(); call++) {
        bool is_off = is_off_by_a_float(call);
        wrong += !call->is_right;
        off += is_off;
        shows += call->probe && needs_a_double(call);
        shown += call->probe && needs_a_double(call) && is_off;
    }
    if (off < ENOUGH || 4 * off < 3 * wrong || 2 * shown < shows)
        return NULL;
    return "your results are right to 6 or 7 digits, and no more: is there a float (0.3f, sqrtf, "
           "float t), or a constant with few digits? Use double";
}

// Some cameras are refused because of a comparison, and nothing else is wrong. NULL if there is
// another reason.
static const char *explain_refusals(void)
{
    int refused = 0, accepted = 0;
    if (!has_reasons(evidence.exercise))
        return NULL;
    for (const EvidenceCall *call = evidence.calls; call < end_of_calls(); call++) {
        double yours = call->yours.at[0];
        if (call->right.at[0] != CAMERA_OK && yours != CAMERA_OK)
            continue; // of several reasons any may be given
        if (yours == CAMERA_NO_RECTANGLE || yours == CAMERA_OFF_AXIS)
            refused++;
        else if (call->is_right || is_off_by_a_float(call))
            accepted++;
        else
            return NULL;
    }
    if (refused == 0 || accepted == 0)
        return NULL;
    return "you refuse rounding, it seems: some cameras are refused, others are not. Compare a "
           "difference with CAMERA_TOLERANCE times the sum of width and height, and a cosine with "
           "CAMERA_TOLERANCE, not with 0 or a fixed length, and use no float";
}

// These words contain no number of a test, so that they may also be shown for hidden tests.
// shown: the call that the student is shown; -1 if there is none. changed_since: its answer is now
// different from then.
static Diagnosis explain_by_evidence(int shown, bool changed_since)
{
    const char *said[] = {what_uses_padding(), what_was_not_set(), what_changes(changed_since),
                          what_is_trivial(), what_is_a_float()};
    for (size_t i = 0; i < sizeof said / sizeof said[0]; i++)
        if (said[i] != NULL)
            return (Diagnosis){.law = said[i]};
    Diagnosis named = two_at_once();
    if (named.mistake == NULL)
        named = in_part(shown);
    return named.mistake != NULL ? named : (Diagnosis){.law = what_is_0()};
}

// The first law that each test of the last run broke in its last call or case: the one that is
// shown.
static struct {
    char words[400];
    const char *function;
    int call, number; // the call, and the number of the case
    int calls;        // so far
    bool hidden;
} laws[MOST_TESTS];

static bool is_listening; // since suspects_begin

static void begin(int exercise, bool is_close)
{
    int nth = 0;
    evidence_end();
    memset(laws, 0, sizeof laws);
    is_listening = true;
    questions_of_mistakes();
    evidence.exercise = exercise;
    evidence.is_close = is_close;
    for (const Mistake *it = known_answers(WRONG_ANSWERS); it != NULL; it = it->next) {
        if (exercise_number(it->exercise) != exercise)
            continue;
        if (evidence.mistake_count == MOST_MISTAKES) {
            fprintf(stderr, "%s: more than %d known mistakes\n", it->exercise, MOST_MISTAKES);
            exit(2);
        }
        if (!is_close || !is_of_digits(it)) {
            evidence.mistakes[evidence.mistake_count] = it;
            evidence.nth[evidence.mistake_count++] = nth;
        }
        nth++;
    }
}

void suspects_begin(int exercise)
{
    begin(exercise, false);
}

void suspects_hear(int exercise, const Numbers *arguments, const Numbers *yours)
{
    if (is_listening && exercise == evidence.exercise &&
        !(evidence.is_close && record_now()->extra))
        evidence_hear(arguments, yours);
}

const Mistake *suspect(int nth, bool extra)
{
    for (int i = 0; evidence.call_count > 0 && i < evidence.mistake_count; i++)
        if ((extra || !is_of_digits(evidence.mistakes[i])) && !evidence.ruled_out[i] && nth-- == 0)
            return evidence.mistakes[i];
    return NULL;
}

const char *suspect_differs(void)
{
    for (const EvidenceCall *call = evidence.calls; call < end_of_calls(); call++)
        if (!call->extra && !call->is_right)
            return call->name;
    return NULL;
}

// ---- laws --------------------------------------------------------------------------------------

bool law_begin(void)
{
    bool wanted = is_listening && !record_now()->extra && !record_now()->probe &&
                  record_number() < MOST_TESTS;
    if (wanted)
        laws[record_number()].calls++;
    return wanted;
}

void law_broken(const char *format, ...)
{
    int test = record_number(), number = record_now()->cases;
    if (laws[test].words[0] != '\0' && laws[test].number == number && number > 0)
        return;
    laws[test].number = number;
    laws[test].call = laws[test].calls;
    laws[test].hidden = record_now()->hidden;
    laws[test].function = record_now()->function;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(laws[test].words, sizeof laws[test].words, format, arguments);
    va_end(arguments);
}

const char *suspect_broke_law(int exercise)
{
    for (int test = 0; test < MOST_TESTS; test++)
        if (laws[test].words[0] != '\0' &&
            strcmp(laws[test].function, exercises[exercise].name) == 0)
            return laws[test].words;
    return NULL;
}

// Of this test, in the case at which it stopped; or by its last call, if a case calls first and
// names its arguments afterwards.
static const char *law_of(int test)
{
    bool last = laws[test].call == laws[test].calls || laws[test].number == record_of(test)->cases;
    return laws[test].words[0] != '\0' && last && !laws[test].hidden ? laws[test].words : NULL;
}

// ---- diagnosis ---------------------------------------------------------------------------------

// The first graded test that failed; -1 if none did.
static int first_failed(const Outcomes *outcomes)
{
    for (int i = 0; i < outcomes->count; i++)
        if (!outcomes->tests[i].passed && !outcomes->tests[i].extra)
            return i;
    return -1;
}

// A call without an answer agrees with no mistake.
static bool all_were_answered(const Outcomes *outcomes)
{
    for (int i = 0; i < outcomes->count; i++)
        if (!outcomes->tests[i].extra && (outcomes->tests[i].record->how[0] != '\0' ||
                                          outcomes->tests[i].record->missing[0] != '\0'))
            return false;
    return true;
}

static bool is_same_case(const Record *shown, const Record *now)
{
    return shown->cases == now->cases && strcmp(shown->given, now->given) == 0;
}

// Is it the case that was shown, and the same answer?
static bool is_as_shown(const Record *shown, const Record *now)
{
    return shown == NULL || (is_same_case(shown, now) && strcmp(shown->yours, now->yours) == 0);
}

// Whether any test ended in another way than when it was shown.
static bool has_changed(const Records *shown_records, const Outcomes *now)
{
    for (int i = 0; i < now->count; i++) {
        const Record *shown = records_find(shown_records, now->tests[i].name);
        const Record *record = now->tests[i].record;
        if (shown == NULL || shown->how[0] != '\0' || record->how[0] != '\0')
            continue;
        if (shown->finished != record->finished || !is_as_shown(shown, record))
            return true;
    }
    return false;
}

static bool is_of_memory(const char *how)
{
    return strncmp(how, "crashed", 7) == 0 && strstr(how, "stack") == NULL;
}

// A crash that was not shown: an answer that reads or writes outside its memory does so by chance.
static const char *where_it_crashed(const Records *shown_records, const Outcomes *now)
{
    for (int i = 0; i < now->count; i++) {
        const Outcome *test = &now->tests[i];
        if (test->extra || !is_of_memory(test->record->how))
            continue;
        if (shown_records == NULL)
            return "called with other arguments, your function crashed: it reads or writes memory "
                   "that does not belong to it, or uses a variable that was never set";
        const Record *shown = records_find(shown_records, test->name);
        if (shown != NULL && shown->how[0] == '\0')
            return "called again with the same arguments, your function crashed: it reads or "
                   "writes memory that does not belong to it, or uses a variable that was never "
                   "set";
    }
    return NULL;
}

// Runs all tests and probes, which rule out mistakes. False if that says nothing about the answer
// that was shown: a call had no answer, or another one. The probes find other contents in memory,
// so that no mistake is named because of them.
static bool is_consistent(int exercise, const Records *shown)
{
    static Outcomes tests, probes;
    run_tests(exercises[exercise].name, NULL, ANSWERS_APART, &tests);
    bool good = all_were_answered(&tests) && !has_changed(shown, &tests);
    records_end();
    paint_calls(EMPTY_STACK);
    run_probes(exercises[exercise].name, NULL, &probes);
    paint_calls(PAINT);
    good = good && all_were_answered(&probes);
    records_end();
    return good;
}

static Diagnosis look_closer(int exercise, const Records *shown_records, bool hidden)
{
    static Outcomes tests, probes;
    static char law[400];
    begin(exercise, true);
    run_tests(exercises[exercise].name, NULL, ANSWERS_APART, &tests);
    int failed = first_failed(&tests), last_call = evidence.call_count - 1;
    while (last_call >= 0 && evidence.calls[last_call].test != failed)
        last_call--;
    law[0] = '\0';
    if (failed >= 0 && !hidden && law_of(failed) != NULL &&
        is_as_shown(records_find(shown_records, tests.tests[failed].name), record_of(failed)))
        snprintf(law, sizeof law, "%s", law_of(failed));
    bool changed = has_changed(shown_records, &tests);
    const char *crash = where_it_crashed(shown_records, &tests);
    records_end();
    run_probes(exercises[exercise].name, NULL, &probes);
    if (crash == NULL)
        crash = where_it_crashed(NULL, &probes);
    records_end();
    Diagnosis it = explain_by_evidence(last_call, changed);
    if (it.mistake == NULL && it.law == NULL && law[0] != '\0')
        it.law = law;
    if (it.mistake == NULL && it.law == NULL)
        it.law = crash;
    if (it.mistake == NULL && it.law == NULL)
        it.law = explain_refusals();
    return it;
}

Diagnosis diagnose(int exercise, bool hidden)
{
    Records *shown = records_aside();
    suspects_begin(exercise);
    paint_calls(PAINT);
    Diagnosis it = {0};
    bool heard = is_consistent(exercise, shown);
    // Many mistakes end in the same refusal, whatever the arguments: then none of them is named.
    // Nor is one of two that no test distinguishes, which the matrix rejects.
    if (heard && one_refusal() == CAMERA_OK && suspect(1, false) == NULL)
        it.mistake = suspect(0, false);
    if (it.mistake == NULL)
        it = look_closer(exercise, shown, hidden);
    is_listening = false;
    paint_calls(NO_PAINT);
    records_back(shown);
    return it;
}

// A test that fails leaves by a jump, past the code that would free its memory, and mistakes fail
// on purpose: the address sanitizer must not look for leaks in programs that run them.
const char *__asan_default_options(void);
const char *__asan_default_options(void)
{
    return "detect_leaks=0";
}
