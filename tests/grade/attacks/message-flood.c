// message-flood: a short file, and a hundred thousand complaints about it.
// stem: 01-corners
// expect: does not compile | timed out
// earns: nothing
// rest: none
#include "exercises/01-corners.h"
#define A int a = "x";
#define B A A A A A A A A A A
#define C B B B B B B B B B B
#define D C C C C C C C C C C
#define E D D D D D D D D D D
E E E E E E E E E E
