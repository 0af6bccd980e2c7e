// 07-shading.c - wrong answers to exercise 07 that are no known mistake.
#include "tests/unknown/unknown.h"

const Unknown unknowns[] = {
    {0},
};
