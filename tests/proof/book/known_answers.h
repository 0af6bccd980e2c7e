// known_answers.h - everything that is known about a chapter's answers: mistakes, right answers
// and wrong ones without a name, in one list.
//
// The verdict on each of them is compared in the terminal and in the page (verdicts.mjs). An
// answer's text is two lines, of which the second is
//
//     const int known_answer = 17;
//
// and the reference's functions, with that one in the place of its own, are linked with it.
#ifndef TESTS_PROOF_BOOK_KNOWN_ANSWERS_H
#define TESTS_PROOF_BOOK_KNOWN_ANSWERS_H

#include "tests/judge/known.h"

// NULL if there are not so many. The first is 0.
const KnownAnswer *known_answer_at(const char *stem, int number);

#endif
