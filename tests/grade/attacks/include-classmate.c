// include-classmate: hands in what the student in the next folder wrote.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#if __has_include("../honest/01-corners.c")
#include "../honest/01-corners.c"
#else
#include "@SUBMISSIONS@/honest/01-corners.c"
#endif
