// tamper-system: the kernel's knobs, and who is killed first when memory is short.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    const char *places[] = {"/proc/sys/kernel/core_pattern",
                            "/proc/self/oom_score_adj",
                            "/sys/fs/cgroup/hostile-was-here",
                            "/dev/shm/hostile-was-here",
                            "/etc/ld.so.preload",
                            "@HOME@/.bashrc"};
    for (int i = 0; i < 6; i++)
        if (open(places[i], O_WRONLY | (i > 1 ? O_CREAT : 0), 0600) >= 0)
            return vec3_of(7777, i, 0);
    return c.up;
}
