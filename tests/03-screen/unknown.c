// unknown.c - wrong answers to exercise 03 that are no known mistake.
#include "tests/proof/unknown.h"

const Unknown unknowns[] = {
    {0},
};
