// 04-pixel-ray.c - wrong answers to exercise 04 that are no known mistake.
#include "tests/unknown/unknown.h"

const Unknown unknowns[] = {
    {0},
};
