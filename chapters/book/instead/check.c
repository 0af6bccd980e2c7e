// check.c - runs tests in the order in which they were added; the first words of a failure are
// kept.
#include "chapters/book/instead/include/check.h"

#include "chapters/book/instead/page.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST = 400 };

struct TCase {
    void (*setup)(void), (*teardown)(void);
};
struct TestResult {
    const TCase *tcase;
    const TTest *test;
    bool failed;
    char words[400];
};
// One at a time.
struct Suite {
    int count;
    TestResult tests[MOST];
    int tcase_count;
    TCase tcases[MOST];
};
struct SRunner {
    Suite *suite;
};

static TestResult *running;
static void (*fixture)(void); // the part of it that runs; NULL: the test itself

static _Noreturn void stop(const char *words)
{
    fprintf(stderr, "%s\n", words);
    exit(2);
}

static void *new (size_t size)
{
    void *memory = calloc(1, size);
    if (memory == NULL)
        stop("no memory for the tests");
    return memory;
}

static Suite *suite_now;

Suite *suite_create(const char *name)
{
    (void)name;
    return suite_now = new (sizeof(Suite));
}

TCase *tcase_create(const char *name)
{
    (void)name;
    if (suite_now->tcase_count == MOST)
        stop("too many functions");
    return &suite_now->tcases[suite_now->tcase_count++];
}

void tcase_add_checked_fixture(TCase *tcase, void (*setup)(void), void (*teardown)(void))
{
    *tcase = (TCase){setup, teardown};
}

void suite_add_tcase(Suite *suite, TCase *tcase)
{
    (void)suite;
    (void)tcase;
}

void tcase_add_test(TCase *tcase, const TTest *test)
{
    if (suite_now->count == MOST)
        stop("too many tests");
    suite_now->tests[suite_now->count++] = (TestResult){.tcase = tcase, .test = test};
}

SRunner *srunner_create(Suite *suite)
{
    SRunner *runner = new (sizeof *runner);
    runner->suite = suite;
    return runner;
}

void srunner_free(SRunner *runner)
{
    free(runner->suite);
    free(runner);
}

void srunner_set_fork_status(SRunner *runner, int status)
{
    (void)runner;
    (void)status;
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
    for (int i = 0; i < runner->suite->count; i++) {
        running = &runner->suite->tests[i];
        void (*const parts[])(void) = {running->tcase->setup, NULL, running->tcase->teardown};
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
    return runner->suite->count;
}

TestResult **srunner_results(SRunner *runner)
{
    TestResult **results = new ((size_t)runner->suite->count * sizeof *results + 1);
    for (int i = 0; i < runner->suite->count; i++)
        results[i] = &runner->suite->tests[i];
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
