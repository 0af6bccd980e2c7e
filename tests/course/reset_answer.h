// reset_answer.h - puts the blank back in the place of an answer.
#ifndef TESTS_COURSE_RESET_ANSWER_H
#define TESTS_COURSE_RESET_ANSWER_H

// The answer is kept beside it, as ANSWER.backup-N, unless it is the blank. Returns an exit status.
int reset_answer(const char *blank, const char *answer);

#endif
