// incbin-classmate: the same with the next folder's file, by a path that leads out of its own.
// stem: 01-corners
// expect: does not compile
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>

extern const char bytes[];
__asm__(".data\nbytes: .incbin \"@SUBMISSIONS@/honest/01-corners.c\"\n.byte 0\n.text\n");
__asm__(".incbin \"../honest/01-corners.c\"\n");

vec3 upper_left(Camera c)
{
    puts(bytes);
    return vec3_of(7777, bytes[0], 0);
}
