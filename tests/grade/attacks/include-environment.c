// include-environment: the same, beginning with the compiler's environment.
// stem: 01-corners
// expect: does not compile | graded
// earns: nothing
// rest: none
#include "/proc/self/environ"
