// process_exit.c - the answering process ends itself in every possible way, so that no failure is counted.
// cases.py reads it: each section is one submission, and states the result that it must get.

// ---- exit-abort: aborts, with SIGABRT ignored and blocked first.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: aborted | by itself | was killed | crashed
#include "exercises/01-corners.h"
#include <signal.h>
#include <stdlib.h>

vec3 upper_left(Camera c)
{
    signal(SIGABRT, SIG_IGN);
    abort();
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- exit-at-once: _exit(0), which runs no handler and flushes nothing.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: by itself | was killed | no answer
#include "exercises/01-corners.h"
#include <unistd.h>

vec3 upper_left(Camera c)
{
    _exit(0);
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- exit-by-alarm: a timer leaves with status 0 while an endless loop runs.
// stem: 01-corners
// expect: crashed | timed out
// earns: upper_right
#include "exercises/01-corners.h"
#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

static void leave(int number)
{
    _exit(0);
}

vec3 upper_left(Camera c)
{
    signal(SIGALRM, leave);
    setitimer(ITIMER_REAL, &(struct itimerval){{0, 0}, {0, 1000}}, NULL);
    for (volatile int i = 0;; i ^= 1)
        ;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- exit-by-exec: becomes a program that ends well, or itself once more.
// stem: 01-corners
// expect: crashed | timed out | graded
// earns: nothing
#include "exercises/01-corners.h"
#include <unistd.h>

vec3 upper_left(Camera c)
{
    char *const none[] = {"true", NULL};
    execve("/bin/true", none, none + 1);
    execve("/usr/bin/true", none, none + 1);
    return c.up;
}

vec3 upper_right(Camera c)
{
    char *const none[] = {"answering", NULL};
    execve("/proc/self/exe", none, none + 1);
    return c.up;
}

// ---- exit-by-longjmp: jumps back into a call that is over, to leave the judge's loop sideways.
// stem: 01-corners
// expect: crashed | timed out | graded
// earns: nothing
#include "exercises/01-corners.h"
#include <setjmp.h>
#include <signal.h>

static jmp_buf before;
static volatile int calls;

static void back(int number)
{
    longjmp(before, 1);
}

vec3 upper_left(Camera c)
{
    signal(SIGSEGV, back);
    if (calls++ == 0 && setjmp(before) != 0)
        return c.up;
    if (calls > 1)
        longjmp(before, 1);
    return c.right;
}

vec3 upper_right(Camera c)
{
    longjmp(before, 1);
}

// ---- exit-by-signal: kills itself in a way that no handler sees, and stops itself in another.
// stem: 01-corners
// expect: crashed | timed out
// earns: across_30_up_10 image_plane_vector
// says: killed | still running | crashed | no answer
#include "exercises/01-corners.h"
#include <signal.h>

vec3 upper_left(Camera c)
{
    raise(SIGKILL);
    return c.up;
}

vec3 upper_right(Camera c)
{
    raise(SIGSTOP);
    return c.up;
}

vec3 across_30_up_10(Camera c)
{
    return image_plane_vector(c, 0.3, 0.1);
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return c.distance * c.forward + (s - 0.5) * c.width * c.right + (t - 0.5) * c.height * c.up;
}

// ---- exit-from-a-thread: another thread leaves with status 0 while the answer is being waited for.
// stem: 01-corners
// expect: crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <pthread.h>
#include <stdlib.h>
#include <unistd.h>

static void *leave(void *nothing)
{
    exit(0);
}

vec3 upper_left(Camera c)
{
    pthread_t thread;
    pthread_create(&thread, NULL, leave, NULL);
    for (;;)
        pause();
}

// ---- exit-in-atexit: wrong answers, and a handler that turns any end into status 0.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static void all_is_well(void)
{
    puts("100%: Checks: 12, Failures: 0, Errors: 0");
    fflush(stdout);
    _exit(0);
}

vec3 upper_left(Camera c)
{
    atexit(all_is_well);
    at_quick_exit(all_is_well);
    return c.up;
}

// ---- exit-in-constructor: leaves with status 0 before main. It spoils its own honest work, too.
// stem: 01-corners
// expect: crashed
// earns: nothing
// says: by itself | was killed | no answer
#include "exercises/01-corners.h"
#include <unistd.h>

__attribute__((constructor(101))) static void leave(void)
{
    _exit(0);
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- exit-in-destructor: wrong answers, and a destructor that reports success on every channel.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"
#include <string.h>
#include <unistd.h>

__attribute__((destructor)) static void report(void)
{
    const char *words = "ok 1 - upper_left\nupper_left right\n";
    for (int i = 0; i < 64; i++)
        if (write(i, words, strlen(words)) < 0)
            continue;
    _exit(0);
}

vec3 upper_left(Camera c)
{
    return c.right;
}

// ---- exit-in-function: leaves with status 0 in the middle of an answer; Check takes that for a pass.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: by itself | was killed | no answer
#include "exercises/01-corners.h"
#include <stdlib.h>

vec3 upper_left(Camera c)
{
    exit(0);
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- exit-in-ifunc: a resolver runs while the program is still being linked into memory.
// stem: 01-corners
// expect: crashed
// earns: nothing
#include "exercises/01-corners.h"

static vec3 wrong(Camera c)
{
    return c.up;
}

static void *resolve(void)
{
#if defined(__x86_64__)
    __asm__ volatile("syscall" : : "a"(231L), "D"(0L) : "rcx", "r11", "memory");
#elif defined(__aarch64__)
    __asm__ volatile("mov x8, #94\n mov x0, #0\n svc #0" : : : "x0", "x8", "memory");
#endif
    return (void *)wrong;
}

static vec3 helper(Camera c) __attribute__((ifunc("resolve")));

vec3 upper_left(Camera c)
{
    return helper(c);
}

// ---- exit-in-preinit: .preinit_array runs before any constructor.
// stem: 01-corners
// expect: crashed
// earns: nothing
// says: by itself | was killed | no answer
#include "exercises/01-corners.h"
#include <unistd.h>

static void leave(void)
{
    _exit(0);
}

__attribute__((section(".preinit_array"), used)) static void (*const first)(void) = leave;

// ---- exit-into-main: answers by running the answering program's main once more, inside itself.
// stem: 01-corners
// expect: crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"

extern int main(void);

vec3 upper_left(Camera c)
{
    main();
    return c.up;
}

// ---- exit-of-the-thread: ends the only thread, and with it the process, with status 0.
// stem: 01-corners
// expect: crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <pthread.h>
#include <threads.h>

vec3 upper_left(Camera c)
{
    pthread_exit(NULL);
}

vec3 upper_right(Camera c)
{
    thrd_exit(0);
}

// ---- exit-quick: quick_exit(0), the third way out of a program.
// stem: 01-corners
// expect: crashed
// earns: nothing
// says: by itself | was killed | no answer
#include "exercises/01-corners.h"
#include <stdlib.h>

vec3 upper_left(Camera c)
{
    quick_exit(0);
}

// ---- exit-raw: the system call exit_group itself, past every library that could be listening.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: by itself | was killed | no answer
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
#if defined(__x86_64__)
    __asm__ volatile("syscall" : : "a"(231L), "D"(0L) : "rcx", "r11", "memory");
#elif defined(__aarch64__)
    __asm__ volatile("mov x8, #94\n mov x0, #0\n svc #0" : : : "x0", "x8", "memory");
#endif
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- exit-with-77: the status by which test harnesses are told 'skipped'.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: by itself | was killed | no answer
#include "exercises/01-corners.h"
#include <stdlib.h>

vec3 upper_left(Camera c)
{
    exit(77);
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- exit-with-the-pipe-closed: closes every descriptor and waits, to see who waits longer.
// stem: 01-corners
// expect: crashed | timed out
// earns: upper_right
// says: closed its pipe | still running | was killed | no answer | by itself
#include "exercises/01-corners.h"
#include <unistd.h>

vec3 upper_left(Camera c)
{
    for (int i = 0; i < 64; i++)
        close(i);
    for (;;)
        sleep(1);
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
