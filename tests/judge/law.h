// law.h - how a law says that it was broken.
#ifndef TESTS_JUDGE_LAW_H
#define TESTS_JUDGE_LAW_H

// In a sentence with the numbers. Only the first of an exercise is kept.
void law_broken(const char *format, ...) __attribute__((format(printf, 1, 2)));

#endif
