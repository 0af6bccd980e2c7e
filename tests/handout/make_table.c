// make_table.c - makes the table of a stem from its tests, the reference and the mistakes.
//
//   tell STEM FILE
//   tell STEM --formulas    prints the formulas of the mistakes, a line each: a handout must not
//                           contain them
//
// First each test runs as it is, and its calls are written down. Then it runs again and again with
// one result changed a little, to find out which other results it accepts: the table is as strict
// as the test, and each tolerance is written in one place.
#include "tests/handout/accepted_results.h"
#include "tests/handout/test_recorder.h"

#include "tests/judge/record.h"
#include "tests/judge/runner.h"
#include "tests/judge/stem.h"
#include "tests/judge/suspects.h"

#include <string.h>

static Told told;
static Outcomes all;

static void add_test(const Outcome *outcome, bool probe)
{
    ToldTest test = {.function = (char *)outcome->function,
                     .name = (char *)outcome->name,
                     .extra = outcome->extra,
                     .probe = probe};
    bool passed = asked_of(&test);
    if (!passed || test.call_count == 0) {
        fprintf(stderr, "%s: %s\n", test.name,
                passed ? "asks nothing" : "the reference does not pass");
        exit(1);
    }
    if (!probe)
        takes_for_right(&test);
    told.tests = told_grow(told.tests, &told.test_count, sizeof *told.tests);
    told.tests[told.test_count - 1] = test;
}

static void add_probes(int exercise)
{
    static Outcomes probes;
    run_probes(exercise, NULL, &probes);
    records_end();
    for (int i = 0; i < probes.count; i++)
        add_test(&probes.tests[i], true);
}

static void add_mistake(const Mistake *mistake)
{
    told.mistakes = told_grow(told.mistakes, &told.mistake_count, sizeof *told.mistakes);
    told.mistakes[told.mistake_count - 1] =
        (ToldMistake){.function = (char *)mistake->exercise,
                      .why = (char *)mistake->why,
                      .picture = (char *)mistake->picture,
                      .digits = strncmp(mistake->id, "X-", 2) == 0};
}

static int say_formulas(void)
{
    const Mistake *const *mistakes = chosen_mistakes();
    for (int table = 0; mistakes[table] != NULL; table++)
        for (int i = 0; mistakes[table][i].id != NULL; i++)
            puts(mistakes[table][i].formula);
    return 0;
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        fprintf(stderr, "Usage: %s STEM FILE|--formulas\n", argv[0]);
        return 2;
    }
    const char *stem = argv[1];
    choose_stem(stem);
    if (strcmp(argv[2], "--formulas") == 0)
        return say_formulas();
    FILE *file = fopen(argv[2], "wb");
    if (file == NULL) {
        perror(argv[2]);
        return 2;
    }
    const Mistake *const *mistakes = chosen_mistakes();
    switch_to_process(stem);
    asked_begin();
    run_tests(NULL, NULL, ANSWERS_APART, &all);
    records_end();
    for (int i = 0; i < all.count; i++)
        add_test(&all.tests[i], false);
    agree_on_lengths(&told);
    for (int i = 0; exercises[i].name != NULL; i++)
        if (strcmp(exercises[i].stem, stem) == 0)
            add_probes(i);
    for (int table = 0; mistakes[table] != NULL; table++)
        for (int i = 0; mistakes[table][i].id != NULL; i++)
            add_mistake(&mistakes[table][i]);
    bool written = told_write(file, &told);
    if (fclose(file) != 0 || !written) {
        perror(argv[2]);
        return 1;
    }
    return 0;
}
