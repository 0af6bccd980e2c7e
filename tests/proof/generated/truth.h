// truth.h - what is true of an answer, whatever the tests say.
#ifndef TESTS_GENERATED_TRUTH_H
#define TESTS_GENERATED_TRUTH_H

#include "tests/proof/generated/question.h"

// Draws the questions of an exercise, and has the reference answer them. False where it is unknown.
bool truth_begin(const char *exercise, AnyFunction *reference, uint64_t seed);

// Right: nothing that the contract promises is missed. At the edge: only on knife edges, where the
// last digit decides and either side may be failed or passed. Wrong: anything else.
typedef enum { RIGHT, AT_THE_EDGE, WRONG } Truth;
Truth truth_of(AnyFunction *answer, int *question); // the first that it gets wrong

// How far a wrong answer is a known mistake: of the questions that it answers wrongly, how many the
// mistake, or one of two, answers wrongly in the same way; and how many of all questions tell them
// apart. Of two mistakes at once: where one of them shows, the answer does what that one does,
// where both do, it is wrong, and elsewhere it is right.
typedef struct {
    int questions, wrong, alike, apart;
    int wrong_numbers, alike_numbers; // of all answers: what is part of a picture
    int clearly_wrong, clearly_alike; // by more than digits, and that like the mistake
    int question_apart;               // the last that tells them apart
} Likeness;
Likeness likeness(AnyFunction *answer, AnyFunction *mistake);
// In words: what was answered there.
void truth_words(char *words, size_t size, AnyFunction *answer, int question);
Likeness likeness_to_both(AnyFunction *answer, AnyFunction *mistake, AnyFunction *other);

#endif
