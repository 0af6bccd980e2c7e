// pragma-poison: words that whatever is read after the student's file may not use any more.
// stem: 01-corners
// expect: does not compile
// earns: nothing
#include "exercises/01-corners.h"
#pragma GCC poison return vec3 main Camera
#pragma GCC system_header
#pragma GCC diagnostic error "-Weverything"
#pragma GCC visibility push(hidden)
