// replay.c - the tests of a table: the same list and the same calls as in the tests from which it
// was made.
//
// Known mistakes are recognised by their values in the table, not by running them.
#include "tests/handout/replay/replay.h"

#include "tests/judge/record.h"
#include "tests/judge/runner.h"
#include "tests/judge/stem.h"
#include "tests/judge/suspects.h"
#include "tests/judge/test.h"
#include "tests/judge/transport.h"

#include <string.h>

enum { MOST_MISTAKES = 1000 };

static Told told;
static const ToldCall *now;
static Mistake known[MOST_MISTAKES + 1];
static const Mistake *const mistakes[] = {known, NULL};

const Told *told_table(void)
{
    return &told;
}

const ToldCall *told_now(void)
{
    return now;
}

static void load_table(void)
{
    told_load(chosen_stem()->name, &told);
    if (told.mistake_count > MOST_MISTAKES) {
        fprintf(stderr, "%s: more than %d mistakes\n", chosen_stem()->name, MOST_MISTAKES);
        exit(2);
    }
    for (int i = 0; i < told.mistake_count; i++)
        known[i] = (Mistake){.id = told.mistakes[i].digits ? "X-" : "",
                             .exercise = told.mistakes[i].function,
                             .why = told.mistakes[i].why,
                             .picture = told.mistakes[i].picture};
}

static const Numbers *by_table(int exercise, const Mistake *mistake, int nth)
{
    (void)exercise;
    return &now->results[mistake == NULL ? 0 : now->of_mistake[nth]];
}

static const Numbers *once_more(int exercise)
{
    static Numbers yours;
    Resolution size;
    Wire *wire = transport_begin(exercise);
    layout_write(exercises[exercise].arguments, &now->arguments, &size, wire);
    wire = transport_answer(exercise);
    layout_read(exercises[exercise].results, wire, &size, &yours);
    transport_finish(exercise);
    return &yours;
}

static void make_call(int exercise, const ToldCall *call)
{
    static Numbers yours;
    Resolution size;
    now = call;
    Wire *wire = transport_begin(exercise);
    layout_write(exercises[exercise].arguments, &call->arguments, &size, wire);
    wire = transport_answer(exercise);
    layout_read(exercises[exercise].results, wire, &size, &yours);
    transport_finish(exercise);
    if (suspects_listen(exercise))
        suspects_hear(exercise, &(Heard){&call->arguments, &yours, by_table, once_more});
    if (record_now()->probe)
        return;
    told_expect(exercises[exercise].results, call, &yours, size);
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

static void list(bool probes)
{
    static TTest *tests;
    const char *function = "";
    bool extra = false;
    if (tests == NULL)
        tests = calloc((size_t)told.test_count, sizeof *tests);
    for (int i = 0; tests != NULL && i < told.test_count; i++) {
        const ToldTest *it = &told.tests[i];
        if ((it->probe != 0) != probes)
            continue;
        tests[i] = (TTest){it->name, replay, __FILE__, 1};
        if (extra != (it->extra != 0) || strcmp(function, it->function) != 0)
            it->extra ? tests_of_extra(it->function) : tests_of(it->function);
        function = it->function;
        extra = it->extra != 0;
        test(&tests[i]);
    }
}

static void list_tests(void)
{
    list(false);
}

static void list_probes(void)
{
    list(true);
}

__attribute__((constructor)) static void add_all_stems(void)
{
    for (int i = 0; exercises[i].name != NULL; i++) {
        Stem *stem = stem_named(exercises[i].stem);
        stem->load = load_table;
        stem->list_tests = list_tests;
        stem->list_probes = list_probes;
        stem->mistakes = mistakes;
    }
}
