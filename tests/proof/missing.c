// missing.c - what an exercise that was just added to the list still lacks.
//
// Without this it would be absent from verdicts and marks without a word: nobody calls it.
#include "tests/proof/missing.h"

#include <stdio.h>
#include <string.h>

static bool is_declared(const Exercise *exercise)
{
    char path[1000], line[1000], call[200];
    snprintf(path, sizeof path, "exercises/%s.h", exercise->stem);
    snprintf(call, sizeof call, "%s(", exercise->name);
    FILE *file = fopen(path, "r");
    bool found = false;
    while (file != NULL && !found && fgets(line, sizeof line, file) != NULL)
        found = strncmp(line, "//", 2) != 0 && strstr(line, call) != NULL;
    if (file != NULL)
        fclose(file);
    return found;
}

bool missing_next(const Exercise *exercise, bool has_test, bool has_mistake, char *words,
                  size_t size)
{
    const char *stem = exercise->stem, *name = exercise->name;
    if (!is_declared(exercise))
        snprintf(words, size, "%s is not declared: the contract is exercises/%s.h", name, stem);
    else if (exercise->reference == NULL)
        snprintf(words, size, "%s has no solution: it belongs in solutions/%s.c", name, stem);
    else if (!has_test)
        snprintf(words, size, "%s has no graded test: tests_of(\"%s\") in tests/%s.c", name, name,
                 stem);
    else if (!has_mistake)
        snprintf(words, size, "%s has no known mistake: they belong in tests/%s/mistakes.c", name,
                 stem);
    else
        return false;
    return true;
}
