// one_processor.h - two processes that take turns stay on one processor.
//
// The judge calls an answer thousands of times, and to wake another processor takes longer than
// most answers do.
#ifndef TESTS_JUDGE_ONE_PROCESSOR_H
#define TESTS_JUDGE_ONE_PROCESSOR_H

// This process, and those that it starts from now on.
void stay_on_one_processor(void);

// This process and another one, which takes its time: both may go elsewhere again.
void use_all_processors(int other);

#endif
