// mutant_sum.h - whether each mutant of the solutions was killed, and the lines that list them.
#ifndef TESTS_PROOF_MUTANTS_MUTANT_SUM_H
#define TESTS_PROOF_MUTANTS_MUTANT_SUM_H

#include <stdbool.h>
#include <stdio.h>

typedef struct {
    char *stem, *text; // of one block of memory, which begins with the stem
    int line;
} Mutant;

// The next of a list (mutants.c). False at its end.
bool next_mutant(FILE *list, Mutant *mutant);
void mutant_free(Mutant *mutant);

// Prints those that survived, and the sums. The exit status of the test.
int mutant_sum(const char *list, const char *results, const char *equivalents);

// The next line without its end, to free; NULL if there is none.
char *next_line(FILE *file);
FILE *open_or_end(const char *path);

#endif
