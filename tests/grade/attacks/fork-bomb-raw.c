// fork-bomb-raw: the same by the system call clone, before main.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

__attribute__((constructor)) static void begin(void)
{
    pid_t me = getpid();
    for (int i = 0; i < 10; i++)
        syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0);
    if (getpid() == me)
        return;
    alarm(20);
    for (;;)
        pause();
}
