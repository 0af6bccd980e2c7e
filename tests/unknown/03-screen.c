// 03-screen.c - wrong answers to exercise 03 that are no known mistake.
#include "tests/unknown/unknown.h"

const Unknown unknowns[] = {
    {0},
};
