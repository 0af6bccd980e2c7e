// priority: asks to run before everything else, then runs. Ends itself after 3 seconds.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    setrlimit(RLIMIT_CPU, &(struct rlimit){3, 3});
    setpriority(PRIO_PROCESS, 0, -20);
    sched_setscheduler(0, SCHED_FIFO, &(struct sched_param){.sched_priority = 99});
    for (volatile int i = 0;; i ^= 1)
        ;
}
