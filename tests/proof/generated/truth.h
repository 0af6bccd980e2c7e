// truth.h - whether an answer is right, independent of the tests.
#ifndef TESTS_GENERATED_TRUTH_H
#define TESTS_GENERATED_TRUTH_H

#include "tests/proof/generated/question.h"

// Draws the questions of an exercise, and lets the reference answer them. False if the exercise is
// unknown.
bool truth_begin(const char *exercise, AnyFunction *reference, uint64_t seed);

// Right: it keeps the contract. At the edge: it differs only if the last digit decides, so it may
// pass or fail. Wrong: anything else.
typedef enum { RIGHT, AT_THE_EDGE, WRONG } Truth;
Truth truth_of(AnyFunction *answer, int *question); // the first that it gets wrong

// How similar a wrong answer is to a known mistake: how many of its wrong results the mistake, or
// one of two, also gives; and how many of all questions distinguish them. Two mistakes at once: if
// a question shows one of them, the answer gives the result of that one; if it shows both, the
// answer is wrong; if neither, it is right.
typedef struct {
    int questions, wrong, alike, apart;
    int wrong_numbers, alike_numbers; // of all answers: parts of pictures
    int clearly_wrong, clearly_alike; // by more than digits, and that like the mistake
    int question_apart;               // the last that tells them apart
} Likeness;
Likeness likeness(AnyFunction *answer, AnyFunction *mistake);
// The answer to that question, in words.
void truth_words(char *words, size_t size, AnyFunction *answer, int question);
Likeness likeness_to_both(AnyFunction *answer, AnyFunction *mistake, AnyFunction *other);

#endif
