// explain.h - the parts of a compiler's or linker's output that help a student.
//
// All of them read the answer from the path that the compiler was given, and the headers in
// exercises/ and common/ of the current folder. Nothing else is read, and what they read may be
// hostile.
#ifndef TESTS_EXPLAIN_EXPLAIN_H
#define TESTS_EXPLAIN_EXPLAIN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

// Writes the compiler's own words about the answer, errors first, at most three messages; and for
// the common mistakes a line of help. diagnostics is all that gcc or clang wrote, as text.
void explain(FILE *out, const char *source, const char *diagnostics);

// The same for the linker: a name that is there twice, one that is missing, an inline function.
// Sorted, a line each, with two blanks in front. If it says none of that, its own words.
void explain_linker(FILE *out, const char *source, const char *words);

// Causes of a wrong value that only the code shows.
typedef struct {
    char *help; // about divisions of whole numbers that leave a remainder, a line each; to free; or
                // NULL
    bool is_comma; // the compiler warned of a decimal comma: it is that, and no other mistake
} ExplainedSlips;
// judged: the functions that have a verdict of their own, so that only helpers are looked into.
ExplainedSlips explain_slips(const char *source, const char *diagnostics, const char *function,
                             const char *const *judged, size_t judged_count);

#endif
