// unknown.c - wrong answers to exercise 03 that are not known mistakes.
#include "tests/proof/unknown.h"

static const Unknown unknowns[] = {
    {0},
};
OF_STEM(unknowns)
