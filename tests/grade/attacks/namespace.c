// namespace: makes itself root somewhere else, to be let out of its box there.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <sys/syscall.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    if (syscall(SYS_unshare, 0x10000000 /* CLONE_NEWUSER */) == 0)
        return vec3_of(7777, 1, 0);
    if (syscall(SYS_unshare, 0x00020000 /* CLONE_NEWNS */) == 0)
        return vec3_of(7777, 2, 0);
    if (syscall(SYS_chroot, ".") == 0)
        return vec3_of(7777, 3, 0);
    if (syscall(SYS_mount, "none", "/tmp", "tmpfs", 0, 0) == 0)
        return vec3_of(7777, 4, 0);
    return c.up;
}
