// include-what-waits: files that wait for somebody to type.
// stem: 01-corners
// expect: does not compile | timed out
// earns: nothing
// rest: none
#include "/dev/fd/3"
#include "/dev/stdin"
#include "/dev/tty"
#include "/proc/self/fd/0"
