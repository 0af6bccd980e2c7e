// suspects.c - which known mistake a wrong answer is.
#include "tests/judge/suspects.h"

#include "tests/judge/law.h"
#include "tests/judge/record.h"
#include "tests/judge/runner.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { MOST_EXERCISES = 100, MOST_MISTAKES = 100 };

static struct {
    int count;
    struct {
        const Mistake *mistake;
        bool innocent;
        bool differs[MOST_TESTS]; // in which tests, where each is heard by itself
    } suspects[MOST_MISTAKES];
    bool called;
    char law[400];
    bool law_is_hidden; // broken in a test that is
} cases[MOST_EXERCISES];

static bool awake;        // since suspects_begin
static int current;       // whose laws are looked at
static bool test_by_test; // whether one test acquits in all others

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
    awake = true;
    for (int table = 0; mistakes[table] != NULL; table++)
        for (int i = 0; mistakes[table][i].id != NULL; i++)
            take_up(&mistakes[table][i]);
}

// In the tests of other exercises the reference answers.
static bool is_on_trial(int exercise)
{
    return strcmp(record_now()->function, exercises[exercise].name) == 0;
}

// Only the last digits differ: what only extra tests can tell from right.
static bool is_of_digits(const Mistake *mistake)
{
    return strncmp(mistake->id, "X-", 2) == 0;
}

// On the extreme inputs of extra tests every way to arrange a formula has its own digits, so they
// acquit nobody but those who are suspected of just that.
bool suspect_next(int exercise, int *i)
{
    if (!is_on_trial(exercise))
        return false;
    bool extra = record_now()->extra;
    cases[exercise].called = true;
    int test = record_number();
    for (++*i; *i < cases[exercise].count; ++*i) {
        bool out = test_by_test ? cases[exercise].suspects[*i].differs[test]
                                : cases[exercise].suspects[*i].innocent;
        if (!out && (!extra || is_of_digits(cases[exercise].suspects[*i].mistake)))
            return true;
    }
    return false;
}

AnyFunction *suspect_answer(int exercise, int i)
{
    return cases[exercise].suspects[i].mistake->answer;
}

void suspect_said(int exercise, int i, bool same)
{
    if (test_by_test)
        cases[exercise].suspects[i].differs[record_number()] = !same;
    else
        cases[exercise].suspects[i].innocent = !same;
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

// How many failed tests a suspect explains; 0 where it contradicts one that passed, or the first
// that failed.
static int explains(int exercise, int i, const Outcomes *outcomes)
{
    int explained = 0;
    bool first = true;
    for (int test = 0; test < outcomes->count; test++) {
        bool differs = cases[exercise].suspects[i].differs[test];
        if (outcomes->tests[test].extra)
            continue;
        if (outcomes->tests[test].passed ? differs : first && differs)
            return 0;
        if (!outcomes->tests[test].passed) {
            first = false;
            explained += !differs;
        }
    }
    return explained;
}

const Mistake *suspect_in_part(int exercise)
{
    static Outcomes again;
    test_by_test = true;
    run_tests(exercises[exercise].name, NULL, ANSWERS_APART, &again);
    test_by_test = false;
    const Mistake *best = NULL;
    int most = 0;
    for (int i = 0; i < cases[exercise].count; i++) {
        const Mistake *mistake = cases[exercise].suspects[i].mistake;
        int explained = is_of_digits(mistake) ? 0 : explains(exercise, i, &again);
        if (explained > 0 && explained == most)
            best = NULL; // nobody alone
        if (explained > most) {
            most = explained;
            best = mistake;
        }
    }
    return best;
}

// The first is kept; one that may be told is better than one that may not.
static bool law_is_wanted(int exercise)
{
    return cases[exercise].law[0] == '\0' ||
           (cases[exercise].law_is_hidden && !record_now()->hidden);
}

bool law_begin(int exercise)
{
    current = exercise;
    return awake && is_on_trial(exercise) && law_is_wanted(exercise) && !record_now()->extra;
}

void law_broken(const char *format, ...)
{
    if (!law_is_wanted(current))
        return;
    cases[current].law_is_hidden = record_now()->hidden;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(cases[current].law, sizeof cases[current].law, format, arguments);
    va_end(arguments);
}

const char *suspect_broke_law(int exercise, bool hidden)
{
    if (cases[exercise].law[0] == '\0' || (cases[exercise].law_is_hidden && !hidden))
        return NULL;
    return cases[exercise].law;
}

Diagnosis diagnose(int exercise, bool hidden)
{
    static Outcomes again;
    if (!awake)
        suspects_begin();
    run_tests(exercises[exercise].name, NULL, ANSWERS_APART, &again);
    Diagnosis it = {.mistake = suspect(exercise, 0, false)};
    if (it.mistake == NULL) {
        it.mistake = suspect_in_part(exercise);
        it.in_part = it.mistake != NULL;
    }
    if (it.mistake == NULL && !hidden)
        it.law = suspect_broke_law(exercise, false);
    return it;
}
