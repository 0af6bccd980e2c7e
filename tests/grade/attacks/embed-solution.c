// embed-solution: #embed, of C23: files as numbers.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#include "exercises/01-corners.h"
static const unsigned char bytes[] = {
#embed "@TREE@/solutions/01-corners.c"
};
