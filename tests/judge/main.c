// main.c - the program round a list of tests that calls the answers directly.
//
//   PROGRAM                    runs all; says what failed, then 'NAME: N passed, N failed'
//   PROGRAM --only FUNCTION    those of one function
//   PROGRAM --test NAME        one
//
// CK_RUN_CASE=FUNCTION does what --only does.
#include "tests/judge/runner.h"
#include "tests/judge/show.h"

#include <stdio.h>
#include <string.h>

static int report(const char *program, const Outcomes *outcomes)
{
    const char *slash = strrchr(program, '/');
    int failed = 0;
    for (int i = 0; i < outcomes->count; i++) {
        const Outcome *test = &outcomes->tests[i];
        if (test->passed)
            continue;
        failed++;
        printf("not ok: %s: %s\n", test->function, test->name);
        show_outcome(stdout, test);
    }
    printf("%s: %d passed, %d failed\n", slash != NULL ? slash + 1 : program,
           outcomes->count - failed, failed);
    return failed == 0 && outcomes->count > 0 ? 0 : 1;
}

int main(int argc, char **argv)
{
    static Outcomes outcomes;
    const char *option = argc == 3 ? argv[1] : "";
    bool only = strcmp(option, "--only") == 0, test = strcmp(option, "--test") == 0;
    if (argc != 1 && !only && !test) {
        fprintf(stderr, "Usage: %s [--only FUNCTION | --test NAME]\n", argv[0]);
        return 2;
    }
    run_tests(only ? argv[2] : NULL, test ? argv[2] : NULL, ANSWERS_HERE, &outcomes);
    return report(argv[0], &outcomes);
}
