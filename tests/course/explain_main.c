// explain_main.c - the explainer as a program, for scripts and for the grader's sandbox.
//
//   explain SOURCE < compiler-output                   what a student should read of it
//   explain --linker SOURCE < linker-output            the same for the linker
//   explain --slips SOURCE FUNCTION TOLD JUDGED... < compiler-output
//                                                      the file TOLD about a function that is
//                                                      wrong, with what the code explains; JUDGED:
//                                                      all functions
//
// From the top of the tree: it looks into the headers in exercises/ and common/.
#include "tests/course/explain.h"

#include "tests/course/explain_text.h"

#include <stdlib.h>
#include <string.h>

// What is longer only repeats itself.
enum { LONGEST = 1 << 20 };

static const char *all_of(FILE *file)
{
    static char text[LONGEST + 1];
    size_t size = fread(text, 1, LONGEST, file);
    for (size_t i = 0; i < size; i++)
        if (text[i] == '\0')
            text[i] = '?';
    return text;
}

// One after the other, each in its own file.
static void tell_slips(const char *source, const char *function, const char *path, char **judged,
                       int judged_count)
{
    const char *words = all_of(stdin);
    FILE *file = fopen(path, "r");
    if (file == NULL)
        return;
    static char told[LONGEST + 1];
    told[fread(told, 1, LONGEST, file)] = '\0';
    fclose(file);
    char *text = explain_slips(source, words, function, (const char *const *)judged,
                               (size_t)judged_count, told);
    file = text == NULL ? NULL : fopen(path, "w");
    if (file != NULL) {
        fputs(text, file);
        fclose(file);
    }
    free(text);
}

int main(int argc, char **argv)
{
    bool is_option = argc > 1 && argv[1][0] == '-';
    if (argc == 2 && !is_option)
        explain(stdout, argv[1], all_of(stdin));
    else if (argc == 3 && strcmp(argv[1], "--linker") == 0)
        explain_linker(stdout, argv[2], all_of(stdin));
    else if (argc >= 5 && strcmp(argv[1], "--slips") == 0)
        tell_slips(argv[2], argv[3], argv[4], argv + 5, argc - 5);
    else {
        fprintf(stderr, "Usage: explain [--linker] SOURCE < words\n"
                        "       explain --slips SOURCE FUNCTION TOLD JUDGED... < words\n");
        return 2;
    }
    return fflush(stdout) == 0 ? 0 : 1;
}
