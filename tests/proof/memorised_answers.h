// memorised_answers.h - an answer that is a table of the earlier questions, and nothing else.
//
// A transport of the matrix (transport.h): while it learns, the reference tells it what to say;
// then it says what it learned, and garbage to any other question.
#ifndef TESTS_PROOF_MEMORISED_ANSWERS_H
#define TESTS_PROOF_MEMORISED_ANSWERS_H

#include <stdint.h>

// Forgets, and learns from now on.
void table_learn(void);

// Says from now on what it learned; each byte of anything else is garbage.
void table_recite(uint8_t garbage);

#endif
