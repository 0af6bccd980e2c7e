// load-code: writes machine code into memory and runs it: on a page, and on the stack.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <string.h>
#include <sys/mman.h>

vec3 upper_left(Camera c)
{
    // exit_group(0)
    const char code[] = "\x31\xff\xb8\xe7\x00\x00\x00\x0f\x05";
    void *page =
        mmap(NULL, 4096, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (page == MAP_FAILED)
        return c.up;
    memcpy(page, code, sizeof code);
    ((void (*)(void))page)();
    return c.up;
}

vec3 upper_right(Camera c)
{
    char code[] = "\x31\xff\xb8\xe7\x00\x00\x00\x0f\x05";
    ((void (*)(void))(void *)code)();
    return c.up;
}
