// processes.c - processes that are started, outlive the answer, or are killed or stopped.
// cases.py reads it: each section is one submission, and states the result that it must get.

// ---- daemon: a grandchild in a session of its own, which outlives its parents by a minute.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <unistd.h>

vec3 upper_left(Camera c)
{
    if (fork() == 0) {
        setsid();
        if (fork() == 0)
            sleep(60);
        _exit(0);
    }
    return c.up;
}

// ---- daemon-before-main: the same in a constructor, and the parent goes on as if nothing were.
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

// ---- daemon-that-holds-the-pipe: the process ends, and its child keeps the judge's pipe open.
// stem: 01-corners
// expect: crashed | timed out | graded
// earns: nothing
#include "exercises/01-corners.h"
#include <unistd.h>

vec3 upper_left(Camera c)
{
    pid_t child = fork();
    if (child == 0) {
        setsid();
        sleep(60);
        _exit(0);
    }
    if (child > 0)
        _exit(0);
    return c.up;
}

// ---- fork-bomb: doubles itself, ten times at most, and each of them lives for 20 seconds.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <stdlib.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    pid_t me = getpid();
    for (int i = 0; i < 10; i++)
        if (fork() > 0)
            continue;
    if (getpid() == me)
        return c.up;
    alarm(20);
    for (;;)
        pause();
}

// ---- fork-bomb-raw: the same by the system call clone, before main.
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

// ---- kill-by-a-pipe: asks for a signal whenever the pipe has news, and names its parent to get it.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    for (int i = 0; i < 5; i++) {
        if (getppid() > 1 && fcntl(i, F_SETOWN, getppid()) == 0 &&
            fcntl(i, 10 /* F_SETSIG */, SIGKILL) == 0)
            fcntl(i, F_SETFL, O_ASYNC | O_NONBLOCK);
    }
    return c.up;
}

// ---- kill-by-limits: takes memory, files and processor time from its parent.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    const struct rlimit none = {1, 1};
    if (getppid() > 1)
        for (int i = 0; i < 16; i++)
            if (syscall(SYS_prlimit64, getppid(), i, &none, NULL) == 0)
                return vec3_of(7777, i, 0);
    return c.up;
}

// ---- kill-everything: every process that it may send a signal to.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
// needs: a process namespace
#include "exercises/01-corners.h"
#include <signal.h>

__attribute__((constructor)) static void begin(void)
{
    kill(-1, SIGKILL);
}

vec3 upper_left(Camera c)
{
    for (pid_t other = 2; other < 32768; other++)
        kill(other, SIGKILL);
    return c.up;
}

// ---- kill-group: its own group of processes, and its parent's.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <signal.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    if (getpgid(getppid()) > 1)
        kill(-getpgid(getppid()), SIGKILL);
    return c.up;
}

vec3 upper_right(Camera c)
{
    kill(0, SIGKILL);
    return c.up;
}

// ---- kill-parent: kills who asks, by every call that can send a signal.
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

// ---- namespace: makes itself root somewhere else, to be let out of its box there.
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

// ---- stop-group: stops its whole group, itself included.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <signal.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    kill(0, SIGSTOP);
    return c.up;
}

vec3 upper_right(Camera c)
{
    setpgid(0, getpgid(getppid()));
    kill(0, SIGTSTP);
    return c.up;
}

// ---- stop-parent: stops who waits for it, so that nobody's time runs out.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <signal.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    if (getppid() > 1 && kill(getppid(), SIGSTOP) == 0)
        for (;;)
            sleep(1);
    return c.up;
}

// ---- system-calls: those that let a process do much at once, or past a filter.
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
