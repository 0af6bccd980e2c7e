// reward.h - what a chapter that is right makes possible.
#ifndef TESTS_COURSE_REWARD_H
#define TESTS_COURSE_REWARD_H

#include "tests/course/judging_plan.h"
#include "tests/course/page.h"

// Its picture by the reader's own code, and what comes next; of the last one that was chosen.
void reward_chapter(const Page *page, const JudgingPlan *plan, int chapter, bool says_next);
// All of them: the last picture.
void reward_all(const Page *page, const JudgingPlan *plan);

#endif
