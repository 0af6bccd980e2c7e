// laws.h - what must hold of an answer whatever the numbers, and the words for when it does not.
//
// Where no known mistake explains a wrong answer, a law that it breaks still helps: 'your vector
// goes 2 along forward; the plane is 4 ahead'. For each exercise NAME there is
//
//     void law_NAME(RESULT yours, PARAMETERS);
//
// called after each call of it, with what came out (in what pointers lead to, too). It must never
// complain of a right answer, within the contract's tolerance.
#ifndef TESTS_LAWS_H
#define TESTS_LAWS_H

#include "tests/judge/law.h"

#endif
