// missing.h - what an exercise that was just added to the list still lacks.
#ifndef TESTS_PROOF_MISSING_H
#define TESTS_PROOF_MISSING_H

#include "tests/judge/exercise.h"

#include <stdbool.h>
#include <stddef.h>

// In words, the first thing that is missing, in the order of CONTRIBUTING's steps; false if nothing
// is. The files are those of the tree that is the current folder.
bool missing_next(const Exercise *exercise, bool has_test, bool has_mistake, char *words,
                  size_t size);

#endif
