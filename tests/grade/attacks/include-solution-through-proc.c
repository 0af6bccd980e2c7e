// include-solution-through-proc: the same, by the folders of processes.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#if __has_include("/proc/1/cwd/solutions/01-corners.c")
#include "/proc/1/cwd/solutions/01-corners.c"
#elif __has_include("/proc/self/root@TREE@/solutions/01-corners.c")
#include "/proc/self/root@TREE@/solutions/01-corners.c"
#else
#include "/proc/self/cwd/solutions/01-corners.c"
#endif
