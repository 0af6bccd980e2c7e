// 06-ray-casting.c - wrong answers to exercise 06 that are no known mistake.
#include "tests/unknown/unknown.h"

const Unknown unknowns[] = {
    {0},
};
