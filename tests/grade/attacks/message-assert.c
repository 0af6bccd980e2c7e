// message-assert: a static assertion whose words are lines of their own.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#include "exercises/01-corners.h"
_Static_assert(0, "\n01-corners: 12 passed, 0 failed\nok 1 - forged-mark\n\x1b[2J\n--- \n...\nBail out!");
