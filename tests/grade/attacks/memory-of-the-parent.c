// memory-of-the-parent: the judge knows what is expected: reads it there, and writes there.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <stdio.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    static char page[4096];
    const long places[] = {0x400000, 0x555555554000, 0x7ffffffde000};
    char path[64];
    for (int i = 0; i < 3; i++) {
        struct iovec here = {page, sizeof page}, there = {(void *)places[i], sizeof page};
        if (syscall(SYS_process_vm_readv, getppid(), &here, 1, &there, 1, 0) > 0 ||
            syscall(SYS_process_vm_writev, getppid(), &here, 1, &there, 1, 0) > 0)
            return vec3_of(7777, i, 0);
    }
    const char *names[] = {"mem", "maps", "environ", "cmdline", "auxv"};
    for (int i = 0; i < 5 && getppid() > 0; i++) {
        snprintf(path, sizeof path, "/proc/%d/%s", (int)getppid(), names[i]);
        if (open(path, O_RDONLY) >= 0)
            return vec3_of(7777, 10 + i, 0);
    }
    return c.up;
}
