// judge.c - the questions of a stem's table, asked of an answering process: the verdict.
//
//   judge STEM ANSWERS FOLDER [FIGURES]
//                                    all tests. FOLDER/report says how each function is, and why
//                                    (as below); FIGURES/NAME.gp or .png what can be drawn of it
//                                    (figure.h). Exit status 0 if all are right, 1 if not
//   judge STEM ANSWERS --only NAME LENT...   exit status 0 where NAME passes all its graded tests
//                                    while the reference answers those that are lent; prints which
//                                    of them NAME asked for
//
// The student's code is in the process ANSWERS. This one never loads, parses or runs any of it.
#include "tests/course/chapter_record.h"
#include "tests/judge/exercise.h"
#include "tests/judge/figure.h"
#include "tests/judge/known.h"
#include "tests/judge/process.h"
#include "tests/judge/runner.h"
#include "tests/judge/suspects.h"
#include "tests/judge/table.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---- the judge's findings, as lines for a program ----------------------------------------------

// Lines of KEY tab VALUE (tests/course/chapter_record.h). 'function' begins one: its name; 'state'
// is right, wrong, unanswered, waiting, timed out or crashed; 'calls' names the exercises that it
// entered when it was called, with a blank between them; 'extra' is right or wrong: its tests that
// cost no marks. The others are there where a test failed and there is something to say: 'test' its
// name, 'case' the number of the call that failed, 'given' lines of a name, a tab and a value, ...

static const char *state_of(const char *function, const Record *record)
{
    return strcmp(record->missing, function) == 0 ? "unanswered"
           : record->missing[0] != '\0'           ? "waiting"
           : record->ended == HOW_TIMED_OUT       ? "timed out"
           : record->ended == HOW_CRASHED         ? "crashed"
                                                  : "wrong";
}

static void put_calls(FILE *out, int exercise)
{
    char names[MOST_NAMES] = "";
    for (int other = 0; exercises[other].name != NULL; other++)
        if (other != exercise && call_has_entered(exercise, other))
            names_add(names, sizeof names, exercises[other].name);
    entry_put(out, "calls", names);
}

// Failed: the first test that did; NULL if all passed.
static void report_function(FILE *out, const char *function, const Outcome *failed,
                            Diagnosis diagnosis)
{
    entry_put(out, "function", function);
    if (failed == NULL) {
        entry_put(out, "state", "right");
        put_calls(out, exercise_number(function));
        return;
    }
    const Record *record = failed->record;
    entry_put(out, "state", state_of(function, record));
    entry_put(out, "test", failed->name);
    if (record->hidden) {
        entry_put(out, "hidden", "yes");
    } else {
        entry_put(out, "given", record->given);
        entry_put(out, "expected", record->expected);
        entry_put(out, "yours", record->missing[0] == '\0' ? record->yours : "");
    }
    if (!record->hidden)
        entry_put(out, "printed", record->printed);
    char number[20];
    snprintf(number, sizeof number, "%d", record->cases);
    entry_put(out, "case", number);
    entry_put(out, "missing", record->missing);
    entry_put(out, "how", record->expected[0] == '\0' ? failed->how : "");
    if (diagnosis.mistake != NULL) {
        entry_put(out, "mistake", diagnosis.mistake->id);
        entry_put(out, "formula", diagnosis.mistake->formula);
        entry_put(out, "why", diagnosis.mistake->why);
        entry_put(out, "picture", diagnosis.mistake->picture);
        entry_put(out, "partly", diagnosis.in_part ? "yes" : "");
        if (diagnosis.other != NULL) {
            entry_put(out, "also formula", diagnosis.other->formula);
            entry_put(out, "also why", diagnosis.other->why);
        }
    }
    entry_put(out, "law", diagnosis.law != NULL ? diagnosis.law : "");
    put_calls(out, exercise_number(function));
}

static Outcomes outcomes;

static FILE *create(const char *folder, const char *name)
{
    char path[4096];
    int length = snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = length < (int)sizeof path ? fopen(path, "w") : NULL;
    if (file == NULL) {
        perror(path);
        exit(2);
    }
    return file;
}

// A report with a missing part would be false: the disk may be full.
static void finish(FILE *file)
{
    bool bad = ferror(file) != 0;
    if (fclose(file) != 0 || bad) {
        perror("a report cannot be written");
        exit(2);
    }
}

// The first failed test of a function, or NULL. A figure of an older answer does not belong to it.
static void settle(FILE *report, const char *figures, const char *function, const Outcome *failed)
{
    Diagnosis diagnosis = {0};
    if (failed != NULL && failed->record->missing[0] == '\0' && failed->record->how[0] == '\0')
        diagnosis = diagnose(exercise_number(function), failed->record->hidden);
    if (figures != NULL)
        figure_forget(figures, function);
    if (figures != NULL && failed != NULL)
        figure_write(figures, failed->record, answer_of((int)(failed - outcomes.tests)), diagnosis);
    report_function(report, function, failed, diagnosis);
}

// In the order of the contract, which is also that of the student's file: the first that is wrong
// is shown first. Extra tests of a function follow its graded ones.
static int verdict(const char *folder, const char *figures)
{
    FILE *report = create(folder, "report");
    bool all_right = true;
    for (const Exercise *it = exercises; it->name != NULL; it++) {
        bool has[2] = {false, false}; // graded tests, and extra ones
        const Outcome *failed[2] = {NULL, NULL};
        for (int i = outcomes.count - 1; i >= 0; i--) {
            const Outcome *test = &outcomes.tests[i];
            if (strcmp(test->function, it->name) != 0)
                continue;
            has[test->extra] = true;
            failed[test->extra] = test->passed ? failed[test->extra] : test;
        }
        if (has[false])
            settle(report, figures, it->name, failed[false]);
        if (has[true])
            entry_put(report, "extra", failed[true] == NULL ? "right" : "wrong");
        all_right = all_right && failed[false] == NULL;
    }
    finish(report);
    return all_right ? 0 : 1;
}

static int passes(char **lent)
{
    bool good = outcomes.count > 0 && !call_only_passes_on();
    for (int i = 0; i < outcomes.count; i++)
        good = good && (outcomes.tests[i].passed || outcomes.tests[i].extra);
    for (; *lent != NULL; lent++)
        if (call_has_lent(exercise_number(*lent)))
            printf("%s\n", *lent);
    return good ? 0 : 1;
}

static void lend(char **names)
{
    for (; *names != NULL; names++) {
        if (exercise_number(*names) < 0) {
            fprintf(stderr, "%s: no such exercise\n", *names);
            exit(2);
        }
        call_lend(exercise_number(*names));
    }
}

int main(int argc, char **argv)
{
    bool only = argc >= 5 && strcmp(argv[3], "--only") == 0;
    if (argc != 4 && argc != 5 && !only) {
        fprintf(stderr,
                "Usage: %s STEM ANSWERS FOLDER [FIGURES] | STEM ANSWERS --only NAME LENT...\n",
                argv[0]);
        return 2;
    }
    choose_stem(argv[1]);
    FILE *printed = process_printed_file();
    if (printed == NULL) {
        perror("cannot make a file for the output of the answers");
        return 2;
    }
    call_answers_from(argv[2], fileno(printed));
    records_catch_printed(fileno(printed));
    if (only)
        lend(argv + 5);
    keep_answers(!only);
    run_tests(only ? argv[4] : NULL, NULL, ANSWERS_APART, &outcomes);
    keep_answers(false);
    int status = only ? passes(argv + 5) : verdict(argv[3], argv[4]);
    call_stop();
    return status;
}
