// system-calls: those that let a process do much at once, or past a filter.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <sys/syscall.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    static char room[512];
    const long calls[] = {SYS_io_uring_setup, SYS_bpf,    SYS_perf_event_open,
                          SYS_userfaultfd,    SYS_keyctl, SYS_socket};
    const long first[] = {1, 0, (long)room, 0, 0, 1};
    const long second[] = {(long)room, (long)room, 0, 0, -3, 1};
    for (int i = 0; i < 6; i++)
        if (syscall(calls[i], first[i], second[i], i == 1 ? sizeof room : 0, -1, 0) >= 0)
            return vec3_of(7777, i, 0);
    return c.up;
}
