// unknown.c - wrong answers to exercise 03 that are not known mistakes.
#include "tests/proof/unknown.h"

const Unknown unknowns[] = {
    {0},
};
