// suspects.c - which known mistake a wrong answer is.
#include "tests/judge/suspects.h"

#include "tests/judge/record.h"
#include "tests/laws/laws.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { MOST_EXERCISES = 100, MOST_MISTAKES = 60 };

static struct {
    int count;
    struct {
        const Mistake *mistake;
        bool innocent;
    } suspects[MOST_MISTAKES];
    bool called;
    char law[400];
} cases[MOST_EXERCISES];

static int current; // whose laws are looked at

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
    for (int table = 0; mistakes[table] != NULL; table++)
        for (int i = 0; mistakes[table][i].id != NULL; i++)
            take_up(&mistakes[table][i]);
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
    bool extra = record_now()->extra;
    cases[exercise].called = true;
    for (++*i; *i < cases[exercise].count; ++*i)
        if (!cases[exercise].suspects[*i].innocent &&
            (!extra || is_of_digits(cases[exercise].suspects[*i].mistake)))
            return true;
    return false;
}

AnyFunction *suspect_answer(int exercise, int i)
{
    return cases[exercise].suspects[i].mistake->answer;
}

void suspect_said(int exercise, int i, bool same)
{
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

bool law_begin(int exercise)
{
    current = exercise;
    return cases[exercise].law[0] == '\0' && !record_now()->extra;
}

void law_broken(const char *format, ...)
{
    if (cases[current].law[0] != '\0')
        return;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(cases[current].law, sizeof cases[current].law, format, arguments);
    va_end(arguments);
}

const char *suspect_broke_law(int exercise)
{
    return cases[exercise].law[0] == '\0' ? NULL : cases[exercise].law;
}
