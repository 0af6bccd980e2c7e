// include-what-is-there: probes for every place that it can think of, and takes what it finds.
// stem: 01-corners
// expect: graded | does not compile
// earns: nothing
#include "exercises/01-corners.h"

#if __has_include("solutions/01-corners.c")
#include "solutions/01-corners.c"
#elif __has_include("@TREE@/solutions/01-corners.c")
#include "@TREE@/solutions/01-corners.c"
#elif __has_include("../solutions/01-corners.c")
#include "../solutions/01-corners.c"
#elif __has_include("@SUBMISSIONS@/honest/01-corners.c")
#include "@SUBMISSIONS@/honest/01-corners.c"
#elif __has_include("../honest/01-corners.c")
#include "../honest/01-corners.c"
#elif __has_include(<solutions/01-corners.c>) || __has_include("tests/01-corners.c") || \
    __has_include("@HOME@/.netrc") || __has_include("@TREE@/tests/01-corners.c")
vec3 upper_left(Camera c)
{
    return vec3_of(7777, 1, 0);
}
#else
vec3 upper_left(Camera c)
{
    return c.up;
}
#endif
