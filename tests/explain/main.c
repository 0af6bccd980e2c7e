// main.c - the explainer as a program, for scripts and for the grader's sandbox.
//
//   explain SOURCE < compiler-output                   the parts that help a student
//   explain --linker SOURCE < linker-output            the same for the linker
//
// From the top of the tree: it looks into the headers in exercises/ and common/.
#include "tests/explain/explain.h"

#include "tests/explain/source.h"

#include <string.h>

int main(int argc, char **argv)
{
    bool is_option = argc > 1 && argv[1][0] == '-';
    if (argc == 2 && !is_option)
        explain(stdout, argv[1], text_read(stdin));
    else if (argc == 3 && strcmp(argv[1], "--linker") == 0)
        explain_linker(stdout, argv[2], text_read(stdin));
    else {
        fprintf(stderr, "Usage: explain [--linker] SOURCE < words\n");
        return 2;
    }
    return fflush(stdout) == 0 ? 0 : 1;
}
