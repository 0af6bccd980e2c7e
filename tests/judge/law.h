// law.h - laws: properties that hold for every right answer whatever the numbers, and the words for
// a broken one.
//
// If no known mistake explains a wrong answer, a law that it breaks still helps: 'your vector goes
// 2 along forward; the plane is 4 ahead'. For each exercise NAME there is, in
// tests/NN-stem/laws*.c,
//
//     void law_NAME(RESULT yours, PARAMETERS);
//
// called after each call of it, with the results (also those behind pointers). It must never
// complain about a right answer, within the contract's tolerance.
#ifndef TESTS_JUDGE_LAW_H
#define TESTS_JUDGE_LAW_H

// In a sentence with the numbers. Only the first of an exercise is kept.
void law_broken(const char *format, ...) __attribute__((format(printf, 1, 2)));

#endif
