// linking.h - one link of objects with answers, by the commands of the plan.
//
// The linker itself is started, if the plan says how (cc starts two more programs first), or else
// cc with the quicker linker. If that fails, cc alone links again: the quick linker may be gone,
// and the words of the ordinary one are known (explain_linker.c).
#ifndef TESTS_COURSE_LINKING_H
#define TESTS_COURSE_LINKING_H

#include "tests/course/judging_plan.h"
#include "tests/course/programs.h"

typedef struct {
    const JudgingPlan *plan;
    const char *program;
    Command words; // objects, and options as cc takes them
} Linking;

Linking linking_begin(const JudgingPlan *plan, const char *program);

// Objects and libraries, with a blank between them; must stay there.
void linking_add(Linking *linking, const char *objects);

// Adds an option of the plan for one exercise: each NAME in it is replaced by the name.
void linking_tell(Linking *linking, const char *option, const char *name);

// Links, and frees. The linker's exit status; what it says goes into a file.
int linking_end(Linking *linking, const char *said);
void linking_free(Linking *linking);

#endif
