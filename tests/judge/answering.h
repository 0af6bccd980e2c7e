// answering.h - the two ends of an answering process's pipes, as it sees them.
#ifndef TESTS_JUDGE_ANSWERING_H
#define TESTS_JUDGE_ANSWERING_H

enum { CALLS_IN = 3, ANSWERS_OUT = 4 };

#endif
