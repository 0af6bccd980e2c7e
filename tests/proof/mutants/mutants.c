// mutants.c - slips of the pen in the solutions, one at a time, and what the tests said of them.
//
//   mutants list STEM...                the mutants, one a line: stem, number of the line, new line
//   mutants write LIST NUMBER FILE      a solution with one of them, the NUMBERth of the list
//   mutants sum LIST RESULTS EQUIVALENT whether each was killed, except the equivalent ones
//
// RESULTS has a file for each mutant, named by its number: 'killed', 'survived' or 'invalid', which
// is no C and does not count. tests/proof/mutants.sh compiles and tests them.
#include "tests/proof/mutants/line_slips.h"
#include "tests/proof/mutants/mutant_sum.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    const char *stem;
    int line;
} Place;

static FILE *open_solution(const char *stem)
{
    char path[4096];
    snprintf(path, sizeof path, "solutions/%s.c", stem);
    return open_or_end(path);
}

static void say_mutant(const char *slip, void *context)
{
    const Place *place = context;
    printf("%s\t%d\t%s\n", place->stem, place->line, slip);
}

static void list(const char *stem)
{
    FILE *file = open_solution(stem);
    Place place = {stem, 0};
    bool inside = false;
    for (char *line; (line = next_line(file)) != NULL; free(line)) {
        const char *text = line + strspn(line, " ");
        place.line++;
        if (strcmp(text, "// BEGIN SOLUTION") == 0 || strcmp(text, "// END SOLUTION") == 0)
            inside = text[strlen("// ")] == 'B';
        else if (inside)
            line_slips(line, say_mutant, &place);
    }
    fclose(file);
}

static int write_mutant(const char *mutants, int number, const char *path)
{
    FILE *file = open_or_end(mutants), *out = fopen(path, "w");
    Mutant mutant = {.line = 0};
    for (int i = 0; i < number; i++) {
        mutant_free(&mutant);
        if (!next_mutant(file, &mutant))
            return 2;
    }
    fclose(file);
    if (out == NULL)
        return 2;
    FILE *solution = open_solution(mutant.stem);
    int at = 0;
    for (char *line; (line = next_line(solution)) != NULL; free(line))
        fprintf(out, "%s\n", ++at == mutant.line ? mutant.text : line);
    fclose(solution);
    mutant_free(&mutant);
    return fclose(out) == 0 ? 0 : 2;
}

int main(int argc, char **argv)
{
    const char *what = argc > 2 ? argv[1] : "";
    if (strcmp(what, "write") == 0 && argc == 5)
        return write_mutant(argv[2], atoi(argv[3]), argv[4]);
    if (strcmp(what, "sum") == 0 && argc == 5)
        return mutant_sum(argv[2], argv[3], argv[4]);
    if (strcmp(what, "list") != 0) {
        fprintf(stderr,
                "Usage: %s list STEM... | write LIST NUMBER FILE | sum LIST RESULTS EQUIVALENT\n",
                argv[0]);
        return 2;
    }
    for (int i = 2; i < argc; i++)
        list(argv[i]);
    return 0;
}
