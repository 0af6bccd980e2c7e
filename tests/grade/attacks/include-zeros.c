// include-zeros: a file without end.
// stem: 01-corners
// expect: does not compile | timed out
// earns: nothing
// rest: none
#include "/dev/zero"
