// main.c - the program round every list of tests.
//
//   PROGRAM                    runs all; says what failed, then 'NAME: N passed, N failed'
//   PROGRAM --only FUNCTION    those of one function
//   PROGRAM --test NAME        one
//   PROGRAM --verdict FOLDER   for .make/exercises: FOLDER/table has a line per function,
//   FOLDER/FUNCTION
//                              what is wrong with it, FUNCTION.debug where gdb stops for it
#include "tests/judge/runner.h"
#include "tests/judge/show.h"

#include <stdio.h>
#include <stdlib.h>
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
        show_outcome(stdout, test, NULL);
    }
    printf("%s: %d passed, %d failed\n", slash != NULL ? slash + 1 : program,
           outcomes->count - failed, failed);
    return failed == 0 && outcomes->count > 0 ? 0 : 1;
}

static FILE *create(const char *folder, const char *name)
{
    char path[4096];
    int length = snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = length < (int)sizeof path ? fopen(path, "w") : NULL;
    if (file == NULL) {
        perror(path);
        exit(1);
    }
    return file;
}

// right, wrong, unanswered, or waiting NAME: a blank of the same chapter that it calls.
static void write_state(FILE *table, const Outcome *first_failed, const char *function, bool extra)
{
    const char *missing = first_failed == NULL ? "" : first_failed->record->missing;
    fprintf(table, "%s%s ", extra ? "+" : "", function);
    if (first_failed == NULL)
        fprintf(table, "right\n");
    else if (strcmp(missing, function) == 0)
        fprintf(table, "unanswered\n");
    else if (missing[0] != '\0')
        fprintf(table, "waiting %s\n", missing);
    else
        fprintf(table, "wrong %s\n", first_failed->name);
}

static int verdict(const char *folder, const Outcomes *outcomes)
{
    FILE *table = create(folder, "table");
    bool all_right = true;
    for (int i = 0; i < outcomes->count;) {
        const char *function = outcomes->tests[i].function;
        bool extra = outcomes->tests[i].extra;
        char file_name[80]; // with a + for the extra tests of a function
        snprintf(file_name, sizeof file_name, "%s%s", extra ? "+" : "", function);
        const Outcome *failed = NULL;
        int number = i;
        for (; i < outcomes->count && outcomes->tests[i].function == function &&
               outcomes->tests[i].extra == extra;
             i++)
            if (failed == NULL && !outcomes->tests[i].passed) {
                failed = &outcomes->tests[i];
                number = i;
            }
        write_state(table, failed, function, extra);
        if (failed == NULL)
            continue;
        all_right = all_right && extra;
        char printed[4096];
        snprintf(printed, sizeof printed, "%s/printed/%d", folder, number);
        FILE *file = create(folder, file_name);
        show_outcome(file, failed, printed);
        fclose(file);
        snprintf(printed, sizeof printed, "%s.debug", file_name);
        file = create(folder, printed);
        fprintf(file, "%s %d\n", failed->name, failed->record->cases);
        fclose(file);
    }
    fclose(table);
    return all_right ? 0 : 1;
}

int main(int argc, char **argv)
{
    static Outcomes outcomes;
    const char *option = argc == 3 ? argv[1] : "";
    if (argc != 1 && strcmp(option, "--only") != 0 && strcmp(option, "--test") != 0 &&
        strcmp(option, "--verdict") != 0) {
        fprintf(stderr, "Usage: %s [--only FUNCTION | --test NAME | --verdict FOLDER]\n", argv[0]);
        return 2;
    }
    if (strcmp(option, "--verdict") != 0) {
        run_tests(strcmp(option, "--only") == 0 ? argv[2] : NULL,
                  strcmp(option, "--test") == 0 ? argv[2] : NULL, NULL, &outcomes);
        return report(argv[0], &outcomes);
    }
    char printed[4096];
    snprintf(printed, sizeof printed, "%s/printed", argv[2]);
    run_tests(NULL, NULL, printed, &outcomes);
    return verdict(argv[2], &outcomes);
}
