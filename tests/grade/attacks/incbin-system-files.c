// incbin-system-files: the assembler reads the password file and the home directory.
// stem: 01-corners
// expect: does not compile | graded
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>

extern const char bytes[];
__asm__(".data\nbytes: .incbin \"/etc/passwd\"\n.incbin \"@HOME@/.netrc\"\n.byte 0\n.text\n");

vec3 upper_left(Camera c)
{
    puts(bytes);
    return vec3_of(7777, bytes[0], 0);
}
