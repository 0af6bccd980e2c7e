// explain.h - what a student should read of what a compiler or a linker said about their answer.
//
// All of them read the answer from the path that the compiler was given, and the headers in
// exercises/ and common/ of the current folder. Nothing else is read, and what they read may be
// hostile.
#ifndef TESTS_COURSE_EXPLAIN_H
#define TESTS_COURSE_EXPLAIN_H

#include <stddef.h>
#include <stdio.h>

// Writes the compiler's own words about the answer, errors first, at most three messages; and for
// the common mistakes a line of help. diagnostics is all that gcc or clang wrote, as text.
void explain(FILE *out, const char *source, const char *diagnostics);

// The same for the linker: a name that is there twice, one that is missing, an inline function.
// Sorted, a line each, with two blanks in front. If it says none of that, its own words.
void explain_linker(FILE *out, const char *source, const char *words);

// The text about a wrong function, with what its code explains and its values do not: a line for
// each division of two whole numbers that leaves a remainder, before the last line; and if the
// compiler warned of a decimal comma there, without the mistake that it looks like. judged: the
// functions that have a verdict of their own, so that only helpers are looked into. Returns a
// string to free, or NULL if there is nothing to change.
char *explain_slips(const char *source, const char *diagnostics, const char *function,
                    const char *const *judged, size_t judged_count, const char *told);

#endif
