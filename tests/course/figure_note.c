// figure_note.c - the words below a figure that is drawn by wrong answers: which are wrong, and
// why.
#include "tests/course/figure_note.h"

#include "tests/course/chapter_record.h"

#include <string.h>

typedef struct {
    ChapterRecord records[MOST_CHAPTERS];
    bool reached[MOST_CHAPTERS][MOST_FUNCTIONS];
    int count;
} Verdicts;

static void reach(Verdicts *verdicts, const char *name, size_t length);

static void reach_each(Verdicts *verdicts, const char *names)
{
    while (*(names += strspn(names, " ")) != '\0') {
        size_t length = strcspn(names, " ");
        reach(verdicts, names, length);
        names += length;
    }
}

// An answer that a wrong one calls is not to blame; an answer that one waits for is.
static void reach(Verdicts *verdicts, const char *name, size_t length)
{
    for (int i = 0; i < verdicts->count; i++)
        for (int k = 0; k < verdicts->records[i].function_count; k++) {
            const FunctionRecord *function = &verdicts->records[i].functions[k];
            if (strlen(function->name) != length || strncmp(function->name, name, length) != 0 ||
                verdicts->reached[i][k])
                continue;
            verdicts->reached[i][k] = true;
            if (strcmp(function_state(function), "wrong") != 0)
                reach_each(verdicts, function_because(function));
        }
}

// On one line, with a minus sign where a hyphen is one.
static void put_words(FILE *out, const char *words, bool is_formula)
{
    for (; *words != '\0'; words++)
        if (is_formula && words[0] == '-' && words[1] == ' ')
            fputs("\u2212", out);
        else
            putc(*words == '\n' || *words == '\t' ? ' ' : *words, out);
}

static void put_note(FILE *out, const FunctionRecord *function)
{
    const char *formula = function_value(function, "formula"),
               *why = function_value(function, "why");
    fputs(function->name, out);
    if (why[0] == '\0') {
        fputs(" is not right yet.", out);
        return;
    }
    if (formula[0] != '\0') {
        fputs(" looks like ", out);
        put_words(out, formula, true);
    }
    fputs(": ", out);
    put_words(out, why, false);
}

void figure_note(FILE *out, const JudgingPlan *plan, int count, char *const *called)
{
    static Verdicts verdicts;
    bool first = true;
    verdicts.count = plan->count;
    for (int i = 0; i < plan->count; i++)
        record_read(plan_beside(plan, i, ".record").s, &verdicts.records[i]);
    for (int i = 0; i < count; i++)
        reach(&verdicts, called[i], strlen(called[i]));
    for (int i = 0; i < plan->count; i++)
        for (int k = 0; k < verdicts.records[i].function_count; k++) {
            const FunctionRecord *function = &verdicts.records[i].functions[k];
            if (!verdicts.reached[i][k] || strcmp(function_state(function), "wrong") != 0)
                continue;
            if (!first)
                putc(' ', out);
            first = false;
            put_note(out, function);
        }
    if (!first)
        putc('\n', out);
    for (int i = 0; i < plan->count; i++)
        chapter_record_free(&verdicts.records[i]);
    memset(&verdicts, 0, sizeof verdicts);
}
