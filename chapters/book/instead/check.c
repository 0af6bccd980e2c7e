// check.c - runs tests in the order in which they were added; the first words of a failure are
// kept.
#include "chapters/book/instead/include/check.h"

#include "chapters/book/instead/page.h"
#include "tests/judge/runner.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

struct TCase {
    void (*setup)(void), (*teardown)(void);
    const TTest *test;
    bool failed;
    char words[400];
};
struct Suite {
    int count;
    TCase cases[MOST_TESTS];
};
static Suite suite;
static TCase *running;
static void (*fixture)(void); // the part of it that runs; NULL: the test itself

Suite *suite_create(const char *name)
{
    (void)name;
    suite.count = 0;
    return &suite;
}

TCase *tcase_create(const char *name)
{
    (void)name;
    return &suite.cases[suite.count++];
}

void tcase_add_checked_fixture(TCase *tcase, void (*setup)(void), void (*teardown)(void))
{
    *tcase = (TCase){.setup = setup, .teardown = teardown};
}

void tcase_add_test(TCase *tcase, const TTest *test)
{
    tcase->test = test;
}

__attribute__((export_name("guarded"))) void guarded(void);
void guarded(void)
{
    if (fixture != NULL)
        fixture();
    else
        running->test->run(0);
}

void srunner_run_all(SRunner *runner, int words)
{
    (void)words;
    for (running = runner->cases; running < runner->cases + runner->count; running++) {
        void (*const parts[])(void) = {running->setup, NULL, running->teardown};
        for (int k = 0; k < 3; k++) {
            fixture = parts[k];
            if (!guard() && k == 0) // without its beginning a test does not run
                break;
        }
    }
}

void ck_abort_msg(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    if (!running->failed)
        vsnprintf(running->words, sizeof running->words, format, arguments);
    va_end(arguments);
    running->failed = true;
    leave();
}

int srunner_ntests_run(SRunner *runner)
{
    return runner->count;
}

TestResult **srunner_results(SRunner *runner)
{
    TestResult **results = calloc(MOST_TESTS, sizeof *results);
    for (int i = 0; results != NULL && i < runner->count; i++)
        results[i] = &runner->cases[i];
    return results;
}

ResultType tr_rtype(TestResult *result)
{
    return result->failed ? CK_FAILURE : CK_PASS;
}

const char *tr_msg(TestResult *result)
{
    return result->words;
}
