// judge.c - the tests of a stem against an answering process: the verdict.
//
//   judge STEM ANSWERS FOLDER [FIGURES]
//                                    all tests. FOLDER/report says how each function is, and why
//                                    (report.h); FIGURES/NAME.gp or .png what can be drawn of it
//                                    (figure.h). Exit status 0 if all are right, 1 if not
//   judge STEM ANSWERS --only NAME LENT...   exit status 0 where NAME passes all its graded tests
//                                    while the reference answers those that are lent; prints which
//                                    of them NAME asked for
//   judge STEM --mistakes FOLDER     the same of every known mistake, as if it were an answer:
//                                    FOLDER/FUNCTION.ID/report
//
// The functions of STEM are called in the process ANSWERS, those of all other stems are answered by
// the reference (switchboard.h).
//
// The student's code is in the process ANSWERS. This one never loads, parses or runs any of it.
#include "tests/judge/figure.h"
#include "tests/judge/process.h"
#include "tests/judge/process_transport.h"
#include "tests/judge/recorded_calls.h"
#include "tests/judge/report.h"
#include "tests/judge/runner.h"
#include "tests/judge/stem.h"
#include "tests/judge/suspects.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

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
        figure_write(figures, group->failed->record, kept_of((int)(group->failed - outcomes.tests)),
                     diagnosis);
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

// The texts that a student would read for each known mistake: two versions of the tests are
// compared by them (tests/proof/by_hand/record.sh).
static int verdicts_of_mistakes(const char *folder)
{
    const Mistake *const *mistakes = chosen_mistakes();
    for (int table = 0; mistakes[table] != NULL; table++) {
        for (const Mistake *mistake = mistakes[table]; mistake->id != NULL; mistake++) {
            char path[4096];
            int start = snprintf(path, sizeof path, "%s/", folder);
            snprintf(path + start, sizeof path - (size_t)start, "%s.%s", mistake->exercise,
                     mistake->id);
            for (char *slash = path + start; (slash = strchr(slash, '/')) != NULL;)
                *slash = '_';
            if (mkdir(path, 0777) != 0 && errno != EEXIST) {
                perror(path);
                return 2;
            }
            switch_to_reference();
            switch_one(mistake->exercise, mistake->answer);
            run_tests(mistake->exercise, NULL, ANSWERS_APART, &outcomes);
            verdict(path, NULL);
            records_end();
        }
    }
    return 0;
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
    bool all_mistakes = argc == 4 && strcmp(argv[2], "--mistakes") == 0;
    bool only = argc >= 5 && strcmp(argv[3], "--only") == 0;
    if (argc != 4 && argc != 5 && !only) {
        fprintf(stderr,
                "Usage: %s STEM ANSWERS FOLDER [FIGURES] | STEM ANSWERS --only NAME LENT... | "
                "STEM --mistakes FOLDER\n",
                argv[0]);
        return 2;
    }
    choose_stem(argv[1]);
    if (all_mistakes)
        return verdicts_of_mistakes(argv[3]);
    FILE *printed = process_printed_file();
    if (printed == NULL) {
        perror("cannot make a file for the output of the answers");
        return 2;
    }
    switch_to_process(argv[1]);
    call_answers_from(argv[2], fileno(printed));
    records_catch_printed(fileno(printed));
    if (only)
        lend(argv + 5);
    keep_calls(!only);
    run_tests(only ? argv[4] : NULL, NULL, ANSWERS_APART, &outcomes);
    keep_calls(false);
    int status = only ? passes(argv + 5) : verdict(argv[3], argv[4]);
    call_stop();
    return status;
}
