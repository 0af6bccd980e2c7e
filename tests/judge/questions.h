// questions.h - the tests of a table, as the tests of the stem that was chosen (stem.h): they ask
// the table's questions of whoever answers (message.h), and know the right results.
#ifndef TESTS_JUDGE_QUESTIONS_H
#define TESTS_JUDGE_QUESTIONS_H

#include "tests/judge/table.h"

// The one that is being asked.
const Question *question_now(void);

// From now on answers are compared with mistakes and laws.
void questions_of_mistakes(void);

// The result of the nth mistake of the function for it; nth -1: the right one. A camera that is
// refused is so for all reasons that are right (numbers.h).
const Numbers *known_result(int exercise, int nth);

// Asks it once more.
const Numbers *ask_again(int exercise);

#endif
