// answering.h - the ends of an answering process's pipes, as it sees them.
#ifndef TESTS_JUDGE_ANSWERING_H
#define TESTS_JUDGE_ANSWERING_H

// The third is closed when the program starts: until then an errno is written to it if that fails.
enum { CALLS_IN = 3, ANSWERS_OUT = 4, START_ERROR = 5 };

#endif
