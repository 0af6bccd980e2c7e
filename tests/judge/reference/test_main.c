// test_main.c - the program round a list of tests that calls the answers directly.
//
//   PROGRAM [STEM]                    runs all; says what failed, then 'NAME: N passed, N failed'
//   PROGRAM [STEM] --only FUNCTION    those of one function
//   PROGRAM [STEM] --test NAME        one
//
// STEM is needed if the program has the tests of several.
#include "tests/judge/known.h"
#include "tests/judge/runner.h"

#include <stdio.h>
#include <string.h>

static int report(const char *name, const Outcomes *outcomes)
{
    int failed = 0;
    for (int i = 0; i < outcomes->count; i++) {
        const Outcome *test = &outcomes->tests[i];
        if (test->passed)
            continue;
        failed++;
        printf("not ok: %s: %s\n", test->function, test->name);
        show_outcome(test);
    }
    printf("%s: %d passed, %d failed\n", name, outcomes->count - failed, failed);
    return failed == 0 && outcomes->count > 0 ? 0 : 1;
}

int main(int argc, char **argv)
{
    static Outcomes outcomes;
    const char *stem = argc > 1 && argv[1][0] != '-' ? argv[1] : NULL;
    char **rest = argv + (stem != NULL ? 2 : 1);
    int left = argc - (int)(rest - argv);
    const char *option = left == 2 ? rest[0] : "";
    bool only = strcmp(option, "--only") == 0, test = strcmp(option, "--test") == 0;
    if (left != 0 && !only && !test) {
        fprintf(stderr, "Usage: %s [STEM] [--only FUNCTION | --test NAME]\n", argv[0]);
        return 2;
    }
    choose_stem(stem);
    run_tests(only ? rest[1] : NULL, test ? rest[1] : NULL, ANSWERS_HERE, &outcomes);
    const char *slash = strrchr(argv[0], '/');
    return report(stem != NULL ? stem : slash != NULL ? slash + 1 : argv[0], &outcomes);
}
