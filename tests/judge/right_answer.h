// right_answer.h - the right result for a call that was kept: by the reference, or, if there is
// none, by a table (tests/handout/replay/right_answer.c).
#ifndef TESTS_JUDGE_RIGHT_ANSWER_H
#define TESTS_JUDGE_RIGHT_ANSWER_H

#include "tests/judge/record.h"
#include "tests/judge/recorded_calls.h"

// The answer, as it would have crossed the pipe. False if it is not known.
bool right_answer(const Record *record, Kept *kept, Wire *right);

// Of the camera in the arguments: from the eye to the upper left, upper right, lower right and
// lower left corner of the image plane.
bool right_corners(const Record *record, Camera camera, vec3 corners[4]);

#endif
