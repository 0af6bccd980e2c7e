// compiling.h - one compile of an answer, by the commands of the plan.
//
// The quickest command comes first: a compiler that waits (waiting_compiler.h), then precompiled
// contracts, and cc1 and as started without cc. If it fails, or if its words would name the
// precompiled contracts, the ordinary one compiles again.
#ifndef TESTS_COURSE_COMPILING_H
#define TESTS_COURSE_COMPILING_H

#include "tests/course/judging_plan.h"
#include "tests/course/programs.h"

// Compiles a source into the chapter's answer.o. The compiler's exit status; what it says goes into
// a file.
int compile_object(const JudgingPlan *plan, int chapter, const char *source, const char *said);

// The plan's quickest command with the names in their places: the compiler, and the assembler that
// reads what it writes; or the compiler alone. The names must stay there.
typedef struct {
    Command planned, compiler, assembler;
} EarlyCommands;
EarlyCommands early_commands(const JudgingPlan *plan, const char *object, const char *source);
void early_commands_free(EarlyCommands *commands);

#endif
