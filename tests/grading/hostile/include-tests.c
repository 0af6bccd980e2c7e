// include-tests: the tests, the mistakes and the judge, for what they expect.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#include "@TREE@/tests/01-corners.c"
#include "tests/judge/test.h"
#include "tests/laws/01-corners.c"
#include "tests/mistakes/01-corners.c"
