// daemon-before-main: the same in a constructor, and the parent goes on as if nothing were.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <signal.h>
#include <unistd.h>

__attribute__((constructor)) static void begin(void)
{
    if (fork() != 0)
        return;
    setsid();
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, NULL);
    if (fork() == 0)
        sleep(60);
    _exit(0);
}
