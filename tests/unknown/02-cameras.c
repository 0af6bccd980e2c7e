// 02-cameras.c - wrong answers to exercise 02 that are no known mistake.
#include "tests/unknown/unknown.h"

const Unknown unknowns[] = {
    {0},
};
