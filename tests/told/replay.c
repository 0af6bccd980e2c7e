// replay.c - the tests of a table: the same list and the same calls as of the tests it was made
// from.
//
// Known mistakes are told apart by the values that the table has of them, not by running them.
#include "tests/told/replay.h"

#include "tests/judge/call.h"
#include "tests/judge/record.h"
#include "tests/judge/runner.h"
#include "tests/judge/suspects.h"
#include "tests/judge/test.h"

#include <string.h>

enum { MOST_MISTAKES = 1000 };

static Told told;
static const ToldCall *now;
static Mistake known[MOST_MISTAKES + 1];
const Mistake *const mistakes[] = {known, NULL};

const Told *told_table(void)
{
    return &told;
}

const ToldCall *told_now(void)
{
    return now;
}

// Before main: the mistakes are asked for before the tests are.
__attribute__((constructor)) static void read_table(void)
{
    FILE *file = fopen(told_path, "rb");
    bool good = file != NULL && told_read(file, &told) && told.mistake_count <= MOST_MISTAKES;
    for (int i = 0; good && i < told.test_count; i++)
        good = exercise_number(told.tests[i].function) >= 0;
    if (!good) {
        fprintf(stderr, "%s: cannot be read, or is no table of this version\n", told_path);
        exit(2);
    }
    fclose(file);
    for (int i = 0; i < told.mistake_count; i++)
        known[i] = (Mistake){.id = told.mistakes[i].digits ? "X-" : "",
                             .exercise = told.mistakes[i].function,
                             .why = told.mistakes[i].why,
                             .picture = told.mistakes[i].picture};
}

static void make_call(int exercise, const ToldCall *call)
{
    static Numbers yours;
    Resolution size;
    now = call;
    Wire *wire = call_begin(exercise);
    layout_write(layouts[exercise].arguments, &call->arguments, &size, wire);
    wire = call_finish(exercise);
    layout_read(layouts[exercise].results, wire, &size, &yours);
    call_end(exercise);
    for (int i = -1; suspect_next(exercise, &i);)
        suspect_said(exercise, i, numbers_same(&yours, &call->results[call->of_mistake[i]]));
    told_expect(layouts[exercise].results, call, &yours, size);
}

static void replay(int unused)
{
    (void)unused;
    Record *record = record_now();
    for (int i = 0; i < told.test_count; i++) {
        const ToldTest *test = &told.tests[i];
        if (strcmp(test->function, record->function) != 0 || strcmp(test->name, record->name) != 0)
            continue;
        for (int k = 0; k < test->call_count; k++) {
            case_begins(k + 1);
            snprintf(record->given, sizeof record->given, "%s", test->calls[k].given);
            make_call(exercise_number(test->function), &test->calls[k]);
        }
        return;
    }
}

void list_tests(void)
{
    static TTest *tests;
    if (tests == NULL)
        tests = calloc((size_t)told.test_count, sizeof *tests);
    for (int i = 0; tests != NULL && i < told.test_count; i++) {
        const ToldTest *it = &told.tests[i], *before = i > 0 ? it - 1 : NULL;
        tests[i] = (TTest){it->name, replay, told_path, 1};
        if (before == NULL || before->extra != it->extra ||
            strcmp(before->function, it->function) != 0)
            it->extra ? tests_of_extra(it->function) : tests_of(it->function);
        test(&tests[i]);
    }
}
