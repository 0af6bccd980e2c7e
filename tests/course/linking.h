// linking.h - one link of objects with answers, by the commands of the plan.
#ifndef TESTS_COURSE_LINKING_H
#define TESTS_COURSE_LINKING_H

#include "tests/course/judging_plan.h"
#include "tests/course/programs.h"

// By the linker itself, if the plan says how (cc starts two more programs first); by cc with the
// quicker linker; or by cc alone, whose words are known (explain_linker.c).
typedef enum { LINK_DIRECTLY, LINK_QUICKLY, LINK_PLAINLY } LinkedBy;

typedef struct {
    Command command;
    LinkedBy by;
    char *rest; // of the words, after the objects
} Linking;

Linking linking_begin(const JudgingPlan *plan, LinkedBy by, const char *program);

// Objects and libraries, with a blank between them; must stay there.
void linking_add(Linking *linking, const char *objects);

// Adds an option of the plan for one exercise: each NAME in it is replaced by the name.
void linking_tell(Linking *linking, const char *option, const char *name);

// Links, and frees. The linker's exit status; what it says goes into a file.
int linking_end(Linking *linking, const char *said);

#endif
