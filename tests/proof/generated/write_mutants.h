// write_mutants.h - writes mutants: functions with one slip or two, a line each.
#ifndef TESTS_PROOF_GENERATED_WRITE_MUTANTS_H
#define TESTS_PROOF_GENERATED_WRITE_MUTANTS_H

#include "tests/proof/generated/slips.h"

enum { MOST_SOURCES = 60 };

typedef struct {
    int source, entry;
    Slip one, two; // two.to is 0 where there is one
    bool bad;      // it is not C
} Mutant;

extern Source *sources[MOST_SOURCES];
extern int line; // that is written next

void end_line(void);
// Everything of a source except its answers' tables.
void put_source(int number);
// The functions on the way from the answer to what was changed, in a line.
void put_mutant(const Mutant *it, int mutant);
// Its row of the table.
void put_row(const Mutant *it, int mutant);

#endif
