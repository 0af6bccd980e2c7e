// suspects.c - which known mistake a wrong answer is, and which law it breaks.
#include "tests/judge/suspects.h"

#include "tests/judge/evidence.h"
#include "tests/judge/explanation.h"
#include "tests/judge/law.h"
#include "tests/judge/record.h"
#include "tests/judge/stack_paint.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { MOST_EXERCISES = 100, MOST_MISTAKES = 100 };

static struct {
    int count;
    struct {
        const Mistake *mistake;
        bool innocent;
    } suspects[MOST_MISTAKES];
    bool called;
    bool refuses, accepts; // of a function that may refuse: it did so, always with the same reason
    int reason;
} cases[MOST_EXERCISES];

// The first law that each test of the last run broke in its last call or case: the one that is
// shown.
static struct {
    char words[400];
    char function[64];
    int call, number; // the call, and the number of the case
    int calls;        // so far
    bool hidden;
} laws[MOST_TESTS];

static bool awake;         // since suspects_begin
static Evidence *evidence; // if every call is recorded: then no mistake is ruled out yet

static void take_up(const Mistake *mistake)
{
    int exercise = exercise_number(mistake->exercise);
    if (exercise < 0 || cases[exercise].count == MOST_MISTAKES) {
        fprintf(stderr, "mistake %s of %s: no such exercise, or more than %d of them\n",
                mistake->id, mistake->exercise, MOST_MISTAKES);
        return;
    }
    cases[exercise].suspects[cases[exercise].count++].mistake = mistake;
}

void suspects_begin(void)
{
    memset(cases, 0, sizeof cases);
    memset(laws, 0, sizeof laws);
    awake = true;
    const Mistake *const *mistakes = chosen_mistakes();
    for (int table = 0; mistakes[table] != NULL; table++)
        for (int i = 0; mistakes[table][i].id != NULL; i++)
            take_up(&mistakes[table][i]);
}

// In the tests of other exercises the reference answers.
static bool is_on_trial(int exercise)
{
    return strcmp(record_now()->function, exercises[exercise].name) == 0;
}

// Only the last digits differ: only extra tests can distinguish it from right.
static bool is_of_digits(const Mistake *mistake)
{
    return strncmp(mistake->id, "X-", 2) == 0;
}

bool suspects_listen(int exercise)
{
    return awake && is_on_trial(exercise) && (evidence == NULL || !record_now()->extra);
}

static bool brings(int exercise, int nth, const Heard *heard, const Numbers *yours)
{
    Numbers theirs = numbers_copy(heard->by(exercise, cases[exercise].suspects[nth].mistake, nth));
    settle_freedom(exercise, &theirs);
    bool same = results_agree(exercise, heard->arguments, yours, &theirs);
    if (!same && yours->count == theirs.count)
        same = refusals_agree(exercise, heard->arguments, yours, &theirs,
                              heard->by(exercise, NULL, -1));
    numbers_free(&theirs);
    return same;
}

static void watch_refusals(int exercise, const Numbers *yours)
{
    int reason = yours->count > 0 ? (int)yours->at[0] : 0;
    if (strncmp(exercises[exercise].results, "CameraFault", 11) != 0)
        return;
    if (reason == CAMERA_OK || (cases[exercise].refuses && cases[exercise].reason != reason))
        cases[exercise].accepts = true;
    cases[exercise].refuses = true;
    cases[exercise].reason = reason;
}

// On the extreme inputs of extra tests every way to arrange a formula has its own digits, so they
// rule out only mistakes about digits.
static void acquit(int exercise, const Heard *heard)
{
    bool extra = record_now()->extra;
    Numbers yours = numbers_copy(heard->yours);
    settle_freedom(exercise, &yours);
    cases[exercise].called = true;
    watch_refusals(exercise, heard->yours);
    for (int i = 0; i < cases[exercise].count; i++)
        if (!cases[exercise].suspects[i].innocent &&
            (!extra || is_of_digits(cases[exercise].suspects[i].mistake)))
            cases[exercise].suspects[i].innocent = !brings(exercise, i, heard, &yours);
    numbers_free(&yours);
}

void suspects_hear(int exercise, const Heard *heard)
{
    if (evidence == NULL) {
        acquit(exercise, heard);
        return;
    }
    int nth[MOST_MISTAKES], count = 0;
    for (int i = 0; i < cases[exercise].count; i++)
        if (!is_of_digits(cases[exercise].suspects[i].mistake))
            nth[count++] = i;
    evidence_hear(evidence, heard, nth);
}

const Mistake *suspect(int exercise, int nth, bool extra)
{
    for (int i = 0; cases[exercise].called && i < cases[exercise].count; i++) {
        const Mistake *mistake = cases[exercise].suspects[i].mistake;
        if (!cases[exercise].suspects[i].innocent && (extra || !is_of_digits(mistake)) &&
            nth-- == 0)
            return mistake;
    }
    return NULL;
}

// ---- laws ---------------------------------------------------------------------------------------

bool law_begin(int exercise)
{
    bool wanted = awake && is_on_trial(exercise) && !record_now()->extra && !record_now()->probe &&
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
    snprintf(laws[test].function, sizeof laws[test].function, "%s", record_now()->function);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(laws[test].words, sizeof laws[test].words, format, arguments);
    va_end(arguments);
}

const char *suspect_broke_law(int exercise, bool hidden)
{
    for (int test = 0; test < MOST_TESTS; test++)
        if (laws[test].words[0] != '\0' && (hidden || !laws[test].hidden) &&
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

// ---- diagnosis ----------------------------------------------------------------------------------

void run_probes(int exercise, const char *name, Outcomes *outcomes)
{
    run_listed_probes(exercises[exercise].name, name, outcomes);
}

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
// that was shown: a call had no answer, or another one.
static bool is_heard(int exercise, const Records *shown)
{
    static Outcomes tests, probes;
    run_tests(exercises[exercise].name, NULL, ANSWERS_APART, &tests);
    bool good = all_were_answered(&tests) && !has_changed(shown, &tests);
    records_end();
    run_probes(exercise, NULL, &probes);
    good = good && all_were_answered(&probes);
    records_end();
    return good;
}

static Diagnosis look_closer(int exercise, const Records *shown_records, bool hidden)
{
    static Outcomes tests, probes;
    static Evidence all;
    static const Mistake *known[MOST_MISTAKES];
    static char law[400];
    int count = 0;
    for (int i = 0; i < cases[exercise].count; i++)
        if (!is_of_digits(cases[exercise].suspects[i].mistake))
            known[count++] = cases[exercise].suspects[i].mistake;
    evidence_begin(&all, exercise, known, count);
    evidence = &all;
    memset(laws, 0, sizeof laws);
    run_tests(exercises[exercise].name, NULL, ANSWERS_APART, &tests);
    int failed = first_failed(&tests), last_call = all.call_count - 1;
    while (last_call >= 0 && all.calls[last_call].test != failed)
        last_call--;
    law[0] = '\0';
    if (failed >= 0 && !hidden && law_of(failed) != NULL &&
        is_as_shown(records_find(shown_records, tests.tests[failed].name), record_of(failed)))
        snprintf(law, sizeof law, "%s", law_of(failed));
    bool changed = has_changed(shown_records, &tests);
    const char *crash = where_it_crashed(shown_records, &tests);
    records_end();
    run_probes(exercise, NULL, &probes);
    if (crash == NULL)
        crash = where_it_crashed(NULL, &probes);
    records_end();
    evidence = NULL;
    Diagnosis it = explain_by_evidence(&all, last_call, changed);
    if (it.mistake == NULL && it.law == NULL && law[0] != '\0')
        it.law = law;
    if (it.mistake == NULL && it.law == NULL)
        it.law = crash;
    evidence_end(&all);
    return it;
}

Diagnosis diagnose(int exercise, bool hidden)
{
    Records *shown = records_aside();
    suspects_begin();
    paint_calls(PAINT);
    Diagnosis it = {0};
    bool heard = is_heard(exercise, shown);
    // Many mistakes end in the same refusal, whatever the arguments: then none of them is named.
    // Nor is one of two that no test distinguishes, which the matrix rejects.
    if (heard && (cases[exercise].accepts || !cases[exercise].refuses) &&
        suspect(exercise, 1, false) == NULL)
        it.mistake = suspect(exercise, 0, false);
    if (it.mistake == NULL)
        it = look_closer(exercise, shown, hidden);
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
