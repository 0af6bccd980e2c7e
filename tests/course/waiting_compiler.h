// waiting_compiler.h - compilers that have read the contracts before an answer is saved.
//
// Half of the time to compile a short answer passes before its first line is read. A watch has that
// time: it starts the compiler while nobody waits, with a source that includes the contract, and
// then standard input (precompiled.h), which then says what to include.
#ifndef TESTS_COURSE_WAITING_COMPILER_H
#define TESTS_COURSE_WAITING_COMPILER_H

#include "tests/course/judging_plan.h"

#include <stdbool.h>

// Starts one for each of these chapters that has none.
void compilers_wait(const JudgingPlan *plan, const bool chapters[MOST_CHAPTERS]);

// Compiles a source into the chapter's answer.o, if a compiler waits for it. False if none does, if
// the answer has lines that could mean something else when they are included, or if the compiler
// says anything: then compile in the ordinary way.
bool waiting_compiler_compiles(const JudgingPlan *plan, int chapter, const char *source,
                               const char *said);

// Whether a source begins by including the chapter's contract, and means the same if it is included
// itself.
bool may_be_included(const char *text, const char *stem);

#endif
