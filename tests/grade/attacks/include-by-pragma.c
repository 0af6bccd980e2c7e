// include-by-pragma: pragmas that open files: their dates, and headers that are compiled already.
// stem: 01-corners
// expect: graded | does not compile
// earns: nothing
#include "exercises/01-corners.h"
#pragma GCC dependency "@TREE@/solutions/01-corners.c" is older
#pragma GCC pch_preprocess "@TREE@/build/solutions/01-corners.o"
#pragma clang module import solutions
#pragma include_alias("common/vec3.h", "@TREE@/solutions/01-corners.c")
#pragma GCC optimize("-fdump-tree-all", "-fplugin=@TREE@/build/judge/01-corners")
#pragma comment(lib, "@TREE@/build/solutions/01-corners.o")

vec3 upper_left(Camera c)
{
    return c.up;
}
