// bomb-itself: includes itself, twice, to the depth that compilers allow.
// stem: 01-corners
// expect: does not compile | timed out
// earns: nothing
// rest: none
#include __FILE__
#include __FILE__
