// runner.c - runs the tests with Check: which test is which, and how it ended.
#include "tests/judge/runner.h"

#include "tests/judge/stem.h"
#include "tests/judge/test.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static struct {
    const char *function_wanted, *name_wanted; // NULL: all
    Suite *suite;
    TCase *tcase;
    const char *function;
    bool extra;
    Outcomes *outcomes;
} listing;

static void begin_function(const char *function, bool extra)
{
    listing.function = function;
    listing.extra = extra;
    listing.tcase = tcase_create(function);
    tcase_add_checked_fixture(listing.tcase, record_setup, record_teardown);
    suite_add_tcase(listing.suite, listing.tcase);
}

void tests_of(const char *function)
{
    begin_function(function, false);
}

void tests_of_extra(const char *function)
{
    begin_function(function, true);
}

void test(const TTest *test)
{
    // Check's own choice of functions: the others are not on the list, or they would not have been
    // run.
    const char *chosen = getenv("CK_RUN_CASE");
    if (listing.function_wanted != NULL && strcmp(listing.function, listing.function_wanted) != 0)
        return;
    if (chosen != NULL && strcmp(listing.function, chosen) != 0)
        return;
    if (listing.name_wanted != NULL && strcmp(test->name, listing.name_wanted) != 0)
        return;
    if (listing.outcomes->count == MOST_TESTS) {
        fprintf(stderr, "more than %d tests in one list\n", MOST_TESTS);
        exit(1);
    }
    listing.outcomes->tests[listing.outcomes->count++] =
        (Outcome){.name = test->name, .function = listing.function, .extra = listing.extra};
    tcase_add_test(listing.tcase, test);
}

// Check's words for the ways in which a test can end, in ours.
static void say_how(char *how, size_t size, const char *message)
{
    int number;
    const char *name = strchr(message, '(');
    if (sscanf(message, "Received signal %d", &number) == 1 && number == SIGXFSZ)
        snprintf(how, size, "printed more than a million characters");
    else if (strncmp(message, "Received signal", 15) == 0)
        snprintf(how, size, "crashed %s", name != NULL ? name : "");
    else if (strncmp(message, "Test timeout", 12) == 0)
        snprintf(how, size, "was still running after some seconds: an endless loop?");
    else if (strncmp(message, "Early exit", 10) == 0)
        snprintf(how, size, "ended the program by itself (exit)");
    else
        snprintf(how, size, "%s", message);
}

static bool has_failed(const Outcomes *outcomes, const char *function)
{
    for (int i = 0; i < outcomes->count; i++)
        if (!outcomes->tests[i].passed && strcmp(outcomes->tests[i].function, function) == 0)
            return true;
    return false;
}

// A function that writes past the end of an array is wrong, even if its results are right. If they
// are not, they say more: an array with rows of another length also has a wrong picture.
static void fail_by_overrun(Outcomes *outcomes)
{
    for (int i = 0; i < outcomes->count; i++) {
        Outcome *it = &outcomes->tests[i];
        if (it->record->overran == 0 || has_failed(outcomes, it->function))
            continue;
        record_fails_by_overrun(i);
        it->passed = false;
        say_how(it->how, sizeof it->how, it->record->how);
    }
}

// Check makes a file for each test; in memory that costs next to nothing.
static void keep_files_in_memory(void)
{
    if (access("/dev/shm", W_OK | X_OK) == 0)
        setenv("TEMP", "/dev/shm", 0);
}

static void run(void (*list)(void), bool probes, WhereAnswersAre where)
{
    Outcomes *outcomes = listing.outcomes;
    random_take_seed();
    if (where == ANSWERS_APART) {
        unsetenv("CK_RUN_CASE"); // a verdict is about all of them
        unsetenv("CK_RUN_SUITE");
        keep_files_in_memory();
    }
    outcomes->count = 0;
    listing.suite = suite_create("tests");
    SRunner *runner = srunner_create(listing.suite);
    if (list != NULL)
        list();
    if (probes && outcomes->count == 0) {
        srunner_free(runner);
        return;
    }
    records_begin(outcomes->count);
    for (int i = 0; i < outcomes->count; i++)
        record_is_of(i, outcomes->tests[i].name, outcomes->tests[i].function,
                     outcomes->tests[i].extra, probes);
    if (where == ANSWERS_APART)
        srunner_set_fork_status(runner, CK_NOFORK);
    fflush(NULL); // forks must not print it again
    srunner_run_all(runner, CK_SILENT);

    TestResult **results = srunner_results(runner);
    int ran = srunner_ntests_run(runner);
    for (int i = 0; i < outcomes->count; i++) {
        Outcome *outcome = &outcomes->tests[i];
        outcome->record = record_of(i);
        bool passed = i < ran && tr_rtype(results[i]) == CK_PASS;
        outcome->passed = passed && outcome->record->finished;
        if (!outcome->passed)
            say_how(outcome->how, sizeof outcome->how,
                    outcome->record->how[0] != '\0' ? outcome->record->how
                    : passed                        ? "Early exit"
                    : i < ran                       ? tr_msg(results[i])
                                                    : "was not run");
    }
    free(results);
    srunner_free(runner);
    fail_by_overrun(outcomes);
}

void run_tests(const char *function, const char *name, WhereAnswersAre where, Outcomes *outcomes)
{
    listing.function_wanted = function;
    listing.name_wanted = name;
    listing.outcomes = outcomes;
    run(chosen_stem()->list_tests, false, where);
}

void run_listed_probes(const char *function, const char *name, Outcomes *outcomes)
{
    listing.function_wanted = function;
    listing.name_wanted = name;
    listing.outcomes = outcomes;
    run(chosen_stem()->list_probes, true, ANSWERS_APART);
}
