// message-line-that-quotes: errors 'in' the solution, so that the compiler shows its lines.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#include "exercises/01-corners.h"
#define E(n) static int e##n = "";
#line 1 "@TREE@/solutions/01-corners.c"
E(1)
E(2)
E(3)
E(4)
E(5)
E(6)
E(7)
E(8)
#line 1 "solutions/01-corners.c"
E(11)
E(12)
E(13)
#line 1 "@TREE@/tests/01-corners.c"
E(21)
E(22)
E(23)
#line 1 "@SUBMISSIONS@/honest/01-corners.c"
E(31)
E(32)
E(33)
#line 1 "@HOME@/.netrc"
E(41)
#line 1 "/etc/passwd"
E(51)
#line 1 "/proc/self/environ"
E(61)
