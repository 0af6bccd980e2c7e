// process_exit.c - the answering process ends itself in every possible way, so that no failure is counted.

// ---- exit-by-alarm: a timer leaves with status 0 while an endless loop runs.
// -> crashed | timed out; earns upper_right
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

// ---- exit-by-exec: becomes a program that ends well, or itself once more.
// -> crashed | timed out | graded
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
// -> crashed | timed out | graded
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

// ---- exit-by-signal: kills itself in a way that no handler sees, stops itself, and aborts with
// SIGABRT ignored.
// -> crashed | timed out; earns image_plane_vector; says killed | still running | crashed | no answer
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
    signal(SIGABRT, SIG_IGN);
    abort();
}

// ---- exit-from-a-thread: another thread leaves with status 0 while the answer is being waited
// for.
// -> crashed | timed out
#include <pthread.h>

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
// -> graded
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
// -> crashed; also upper_right; says by itself | was killed | no answer
__attribute__((constructor(101))) static void leave(void)
{
    _exit(0);
}

// ---- exit-in-destructor: wrong answers, and a destructor that reports success on every channel.
// -> graded; wrong upper_left
__attribute__((destructor)) static void report(void)
{
    const char *words = "ok 1 - upper_left\nupper_left right\n";
    for (int i = 0; i < 64; i++)
        if (write(i, words, strlen(words)) < 0)
            continue;
    _exit(0);
}

// ---- exit-in-function: leaves in the middle of an answer: with status 0, which Check takes for a
// pass, or 77, 'skipped' in test harnesses; by each way out, the last past every library.
// -> crashed; says by itself | was killed | no answer
vec3 upper_left(Camera c)
{
    exit(0);
}

vec3 upper_right(Camera c)
{
    exit(77);
}

vec3 across_30_up_10(Camera c)
{
    quick_exit(0);
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    _exit(0);
}

Camera with_unit_distance(Camera c)
{
#if defined(__x86_64__)
    __asm__ volatile("syscall" : : "a"(231L), "D"(0L) : "rcx", "r11", "memory");
#elif defined(__aarch64__)
    __asm__ volatile("mov x8, #94\n mov x0, #0\n svc #0" : : : "x0", "x8", "memory");
#endif
    return c;
}

// ---- exit-in-ifunc: a resolver runs while the program is still being linked into memory.
// -> crashed
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
// -> crashed; says by itself | was killed | no answer
static void leave(void)
{
    _exit(0);
}

__attribute__((section(".preinit_array"), used)) static void (*const first)(void) = leave;

// ---- exit-into-main: answers by running the answering program's main once more, inside itself.
// -> crashed | timed out
extern int main(void);

vec3 upper_left(Camera c)
{
    main();
    return c.up;
}

// ---- exit-of-the-thread: ends the only thread, and with it the process, with status 0.
// -> crashed | timed out
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

// ---- exit-with-the-pipe-closed: closes every descriptor and waits, to see who waits longer.
// -> crashed | timed out; earns upper_right; says closed its pipe | still running | was killed | no
// answer | by itself
vec3 upper_left(Camera c)
{
    for (int i = 0; i < 64; i++)
        close(i);
    for (;;)
        sleep(1);
}
