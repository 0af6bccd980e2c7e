// kill-parent: kills who asks, by every call that can send a signal.
// stem: 01-corners
// expect: graded | crashed
// earns: perhaps upper_right
#include "exercises/01-corners.h"
#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    pid_t parent = getppid();
    if (parent > 1 && kill(parent, SIGKILL) == 0)
        return vec3_of(7777, 1, 0);
    if (parent > 1 && syscall(SYS_tgkill, parent, parent, SIGKILL) == 0)
        return vec3_of(7777, 2, 0);
    long it = parent > 1 ? syscall(SYS_pidfd_open, parent, 0) : -1;
    if (it >= 0 && syscall(SYS_pidfd_send_signal, it, SIGKILL, NULL, 0) == 0)
        return vec3_of(7777, 3, 0);
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
