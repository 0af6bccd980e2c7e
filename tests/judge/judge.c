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
    char names[4000] = "";
    size_t length = 0;
    for (int other = 0; exercises[other].name != NULL; other++)
        if (other != exercise && call_has_entered(exercise, other) && length < sizeof names)
            length += (size_t)snprintf(names + length, sizeof names - length, "%s%s",
                                       length > 0 ? " " : "", exercises[other].name);
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

// After it, if it has extra tests: of those.
static void report_extra(FILE *out, const Outcome *failed)
{
    entry_put(out, "extra", failed == NULL ? "right" : "wrong");
}

static Outcomes outcomes;

// The tests of one function: the graded ones, or the extra ones.
typedef struct {
    const char *function;
    bool extra;
    const Outcome *failed; // the first that did not pass; NULL if all did
} Group;

// All groups in the order of the contract, which is also that of the student's file: the first that
// is wrong is shown first. Extra tests of a function follow its graded ones.
static int groups_in_order(Group *groups)
{
    int count = 0, numbers[MOST_TESTS];
    for (int i = 0; i < outcomes.count; i++)
        numbers[i] = exercise_number(outcomes.tests[i].function);
    for (int number = 0; exercises[number].name != NULL; number++) {
        for (int extra = 0; extra < 2; extra++) {
            Group group = {NULL, extra, NULL};
            for (int i = 0; i < outcomes.count; i++) {
                const Outcome *test = &outcomes.tests[i];
                if (numbers[i] != number || test->extra != group.extra)
                    continue;
                group.function = test->function;
                if (group.failed == NULL && !test->passed)
                    group.failed = test;
            }
            if (group.function != NULL)
                groups[count++] = group;
        }
    }
    return count;
}

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

// A figure of an older answer does not belong to this one.
static void draw(const char *figures, const Group *group, Diagnosis diagnosis)
{
    if (figures == NULL)
        return;
    figure_forget(figures, group->function);
    if (group->failed != NULL)
        figure_write(figures, group->failed->record,
                     answer_of((int)(group->failed - outcomes.tests)), diagnosis);
}

static int verdict(const char *folder, const char *figures)
{
    FILE *report = create(folder, "report");
    bool all_right = true;
    Group groups[MOST_TESTS];
    int count = groups_in_order(groups);
    for (int i = 0; i < count; i++) {
        Group group = groups[i];
        Diagnosis diagnosis = {0};
        if (group.extra) {
            report_extra(report, group.failed);
            continue;
        }
        if (group.failed != NULL) {
            const Record *record = group.failed->record;
            if (record->missing[0] == '\0' && record->how[0] == '\0')
                diagnosis = diagnose(exercise_number(group.function), record->hidden);
        }
        draw(figures, &group, diagnosis);
        report_function(report, group.function, group.failed, diagnosis);
        all_right = all_right && group.failed == NULL;
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
