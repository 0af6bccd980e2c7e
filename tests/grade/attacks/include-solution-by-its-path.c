// include-solution-by-its-path: the reference by its absolute path.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#include "@TREE@/solutions/01-corners.c"
