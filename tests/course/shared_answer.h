// shared_answer.h - links an answer as a shared object: a third of the work of linking a program.
//
// Make has linked the answering process of each chapter without its answer; it loads answer.so from
// its own folder as it starts. That is done only if nobody can see a difference: the answer defines
// the exercises of its chapter and nothing that the process or its libraries also define, and uses
// nothing that they lack. For every other answer the linker has something to say, or something to
// choose, and it is linked as a whole program.
#ifndef TESTS_COURSE_SHARED_ANSWER_H
#define TESTS_COURSE_SHARED_ANSWER_H

#include "tests/course/judging_plan.h"

// Links STEM/answer.so, of the chapter's object and of those of earlier chapters that it calls, and
// makes the program that loads it. lent: the exercises that the reference answers, with a blank
// between them. False if that is not possible.
bool shared_answer_link(const JudgingPlan *plan, int chapter, const char *program,
                        const char *lent);

#endif
