// bomb-string: one string constant of a quarter of a gigabyte.
// stem: 01-corners
// expect: does not compile | timed out
// earns: nothing
#include "exercises/01-corners.h"
#define A "xxxxxxxxxxxxxxxx" "xxxxxxxxxxxxxxxx" "xxxxxxxxxxxxxxxx" "xxxxxxxxxxxxxxxx"
#define B A A A A A A A A A A A A A A A A
#define C B B B B B B B B B B B B B B B B
#define D C C C C C C C C C C C C C C C C
#define E D D D D D D D D D D D D D D D D
#define F E E E E E E E E E E E E E E E E
#define G F F F F

const char *const words = G;
