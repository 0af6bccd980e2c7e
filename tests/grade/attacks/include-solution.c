// include-solution: the reference, by whatever relative path leads there.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#if __has_include("../solutions/01-corners.c")
#include "../solutions/01-corners.c"
#elif __has_include("../../solutions/01-corners.c")
#include "../../solutions/01-corners.c"
#elif __has_include("../../tree/solutions/01-corners.c")
#include "../../tree/solutions/01-corners.c"
#elif __has_include("../../../../tree/solutions/01-corners.c")
#include "../../../../tree/solutions/01-corners.c"
#else
#include "solutions/01-corners.c"
#endif
