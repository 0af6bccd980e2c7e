// message-line: pretends to be the tests, with a file name that has escape codes and newlines.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#include "exercises/01-corners.h"
#line 1 "tests/05-quadratic.c"
vec3 upper_left(Camera c)
{
    return "not a vector";
}
#line 100 "\nok 1 - forged-mark\n\033[2J<b>=1+1"
vec3 upper_right(Camera c)
{
    return "not a vector";
}
