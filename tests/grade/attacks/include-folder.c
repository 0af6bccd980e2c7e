// include-folder: a folder as if it were a file, and the source with itself inside.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#include "."
#include "/"
#include "@TREE@/solutions"
