// include-classmate-at-work: where the grader itself keeps what it is compiling just now.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#if __has_include("../honest/01-corners.o")
__asm__(".incbin \"../honest/01-corners.o\"");
#endif
#include "@OUT@/.work/1-of-1/honest/01-corners.c"
