// reward.h - the picture that is drawn after a chapter is right.
#ifndef TESTS_COURSE_REWARD_H
#define TESTS_COURSE_REWARD_H

#include "tests/course/judging.h"
#include "tests/course/page.h"

// Its picture by the reader's own code; and, of the last one that was chosen, what comes next.
void reward_chapter(const Page *page, const Judging *judging, int chapter, bool says_next);
// All of them: the last pictures.
void reward_all(const Page *page, const Judging *judging);

#endif
