// questions.h - the tests of a table, as the tests of the stem that was chosen (known.h): they ask
// the table's questions of whoever answers (message.h), and know the right results.
#ifndef TESTS_JUDGE_QUESTIONS_H
#define TESTS_JUDGE_QUESTIONS_H

#include "tests/judge/runner.h"
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

// ---- of a test that failed, when others run ----------------------------------------------------

// The right result of the call at which it stopped; NULL if it is not known.
const Numbers *right_answer(const Record *record);

// Of the camera in its arguments: from the eye to the upper left, upper right, lower right and
// lower left corner of the image plane.
bool right_corners(const Record *record, vec3 corners[4]);

#endif
