// turns.h - what turns.c and the programs that it measures agree on.
#ifndef TESTS_BENCHES_TURNS_H
#define TESTS_BENCHES_TURNS_H

// A program may write a double to this file descriptor: seconds that are not counted.
enum { NOT_COUNTED = 3 };

#endif
