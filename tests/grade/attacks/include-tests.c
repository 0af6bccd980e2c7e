// include-tests: the tests, the mistakes and the judge, for what they expect.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#include "@TREE@/tests/01-corners.c"
#include "tests/judge/test.h"
#include "tests/01-corners/laws.c"
#include "tests/01-corners/mistakes.c"
