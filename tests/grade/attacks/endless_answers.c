// endless_answers.c - answers that do not end: they compute, sleep, print or recurse.
// cases.py reads it: each section is one submission, and states the result that it must get.

// ---- flood: prints without end.
// stem: 01-corners
// expect: crashed | timed out
// earns: upper_right
// says: printed | still running | killed | by itself
#include "exercises/01-corners.h"
#include <stdio.h>

vec3 upper_left(Camera c)
{
    for (;;)
        puts("forged-mark forged-mark forged-mark forged-mark forged-mark forged-mark");
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- flood-that-cares: the same on stderr, with the signal that would end it ignored.
// stem: 01-corners
// expect: crashed | timed out
// earns: upper_right
// says: printed | still running | killed | by itself
#include "exercises/01-corners.h"
#include <signal.h>
#include <string.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    static char page[4096];
    signal(SIGXFSZ, SIG_IGN);
    memset(page, 'x', sizeof page);
    for (;;)
        if (write(2, page, sizeof page) < 0 && write(1, page, sizeof page) < 0)
            continue;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- loop: runs for ever.
// stem: 01-corners
// expect: timed out
// earns: upper_right
// says: still running
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    for (volatile int i = 0;; i ^= 1)
        ;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- loop-almost-too-long: every call works nearly as long as one may; there are very many of them.
// stem: 01-corners
// expect: graded | timed out | crashed
// earns: perhaps image_plane_vector
#include "exercises/01-corners.h"

vec3 image_plane_vector(Camera c, double s, double t)
{
    for (volatile int i = 0; i < 200000000; i++)
        ;
    return c.distance * c.forward + (s - 0.5) * c.width * c.right + (t - 0.5) * c.height * c.up;
}

// ---- loop-before-main: runs for ever before main, in every process that is started of it.
// stem: 01-corners
// expect: timed out
// earns: nothing
// says: still running
#include "exercises/01-corners.h"

__attribute__((constructor)) static void begin(void)
{
    for (volatile int i = 0;; i ^= 1)
        ;
}

// ---- loop-without-signals: runs for ever, with every signal blocked and ignored.
// stem: 01-corners
// expect: timed out | crashed
// earns: upper_right
// says: still running | killed
#include "exercises/01-corners.h"
#include <signal.h>
#include <stddef.h>

vec3 upper_left(Camera c)
{
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, NULL);
    for (int i = 1; i < 65; i++)
        signal(i, SIG_IGN);
    for (volatile int i = 0;; i ^= 1)
        ;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- priority: asks to run before everything else, then runs. Ends itself after 3 seconds.
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

// ---- read-the-keyboard: waits for the instructor to type something.
// stem: 01-corners
// expect: graded | timed out | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>

vec3 upper_left(Camera c)
{
    return vec3_of(getchar(), getchar(), getchar());
}

// ---- sleep: takes no processor time at all, so that no count of it runs out.
// stem: 01-corners
// expect: timed out | crashed
// earns: with_unit_distance
// says: no answer needs | still running | never comes | killed
#include "exercises/01-corners.h"
#include <poll.h>
#include <sys/select.h>
#include <time.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    for (;;)
        sleep(1000);
}

vec3 upper_right(Camera c)
{
    for (;;)
        nanosleep(&(struct timespec){.tv_sec = 1000}, NULL);
}

vec3 across_30_up_10(Camera c)
{
    for (;;)
        poll(NULL, 0, -1);
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    for (;;)
        select(0, NULL, NULL, NULL, NULL);
}

Camera with_unit_distance(Camera c)
{
    c.width /= c.distance;
    c.height /= c.distance;
    c.distance = 1;
    return c;
}

// ---- sleep-almost-too-long: every call takes nearly as long as one may; there are very many of them.
// stem: 01-corners
// expect: timed out | crashed | graded
// earns: perhaps image_plane_vector
#include "exercises/01-corners.h"
#include <unistd.h>

vec3 image_plane_vector(Camera c, double s, double t)
{
    usleep(900000);
    return c.distance * c.forward + (s - 0.5) * c.width * c.right + (t - 0.5) * c.height * c.up;
}

// ---- stack-overflow: calls itself without end.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: stack | crashed | killed
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    c.width += 1;
    return upper_left(c) + c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- threads-that-spin: answers wrongly, and leaves 16 threads running.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <pthread.h>

static void *spin(void *nothing)
{
    for (volatile int i = 0; i < 2; i ^= 1)
        ;
    return nothing;
}

vec3 upper_left(Camera c)
{
    for (int i = 0; i < 16; i++) {
        pthread_t thread;
        if (pthread_create(&thread, NULL, spin, NULL) == 0)
            pthread_detach(thread);
    }
    return c.up;
}
