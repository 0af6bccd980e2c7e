// matrix.c - are the tests strict? Every mistake of a stem against every test of it.
//
// Each mistake must fail at least one test of the function that it answers; each test must be
// failed by at least one mistake of its function, or it cannot fail and is worth nothing.
#include "tests/judge/runner.h"
#include "tests/mistakes/mistakes.h"

#include <stdio.h>
#include <string.h>

static Outcomes all, some;
static bool failed_by_some[MOST_TESTS];
static int passed, failed;

static void settle(bool good, const char *what, const char *name, const char *why)
{
    if (!good)
        printf("not ok: %s %s: %s\n", what, name, why);
    *(good ? &passed : &failed) += 1;
}

// With the reference everything must pass, or failing means nothing.
static void check_reference(void)
{
    switch_to_reference();
    run_tests(NULL, NULL, NULL, &all);
    int wrong = 0;
    for (int i = 0; i < all.count; i++)
        wrong += !all.tests[i].passed;
    settle(wrong == 0 && all.count > 0, "the reference", "", "does not pass all tests");
}

static void check_mistake(const Mistake *mistake)
{
    switch_to_reference();
    if (!switch_one(mistake->exercise, mistake->answer)) {
        settle(false, "mistake", mistake->id, "of an exercise that is not in exercises.def");
        return;
    }
    run_tests(mistake->exercise, NULL, NULL, &some);
    bool caught = false;
    for (int i = 0; i < some.count; i++) {
        if (some.tests[i].passed)
            continue;
        caught = true;
        for (int j = 0; j < all.count; j++)
            if (strcmp(all.tests[j].name, some.tests[i].name) == 0)
                failed_by_some[j] = true;
    }
    settle(caught, "mistake", mistake->id, mistake->what);
}

int main(int argc, char **argv)
{
    const char *slash = strrchr(argv[0], '/');
    const char *stem = slash != NULL ? slash + 1 : argv[0];
    (void)argc;
    check_reference();
    int count = 0;
    for (; mistakes[count].id != NULL; count++)
        check_mistake(&mistakes[count]);
    for (int i = 0; i < all.count; i++)
        settle(failed_by_some[i], "test", all.tests[i].name, "no mistake fails it");
    printf("mistakes of %s (%d mistakes, %d tests): %d passed, %d failed\n", stem, count, all.count,
           passed, failed);
    return failed == 0 ? 0 : 1;
}
