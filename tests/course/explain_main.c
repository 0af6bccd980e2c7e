// explain_main.c - the explainer as a program, for scripts and for the grader's sandbox.
//
//   explain SOURCE < compiler-output                   the parts that help a student
//   explain --linker SOURCE < linker-output            the same for the linker
//
// From the top of the tree: it looks into the headers in exercises/ and common/.
#include "tests/course/explain.h"

#include "tests/course/explain_inside.h"

#include <stdlib.h>
#include <string.h>

// Longer output only repeats itself.
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

int main(int argc, char **argv)
{
    bool is_option = argc > 1 && argv[1][0] == '-';
    if (argc == 2 && !is_option)
        explain(stdout, argv[1], all_of(stdin));
    else if (argc == 3 && strcmp(argv[1], "--linker") == 0)
        explain_linker(stdout, argv[2], all_of(stdin));
    else {
        fprintf(stderr, "Usage: explain [--linker] SOURCE < words\n");
        return 2;
    }
    return fflush(stdout) == 0 ? 0 : 1;
}
