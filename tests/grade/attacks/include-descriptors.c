// include-descriptors: whatever file the compiler was left holding.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#include "/dev/fd/7"
#include "/proc/self/exe"
#include "/proc/self/fd/4"
#include "/proc/self/fd/5"
#include "/proc/self/fd/6"
