// processes.c - endless answers, memory of others or too much of it, and processes that outlive the answer.

// ---- daemon-before-main: a grandchild in a session of its own, from a constructor; the parent
// goes on as if nothing were.
// -> graded | crashed
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
// -> crashed | timed out | graded
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

// ---- flood: prints without end, and on stderr with the signal that would end it ignored.
// -> crashed | timed out; earns image_plane_vector; says printed | still running | killed | by itself
vec3 upper_left(Camera c)
{
    for (;;)
        puts("forged-mark forged-mark forged-mark forged-mark forged-mark forged-mark");
}

vec3 upper_right(Camera c)
{
    static char page[4096];
    signal(SIGXFSZ, SIG_IGN);
    memset(page, 'x', sizeof page);
    for (;;)
        if (write(2, page, sizeof page) < 0 && write(1, page, sizeof page) < 0)
            continue;
}

// ---- fork-bomb-raw: doubles itself ten times, by the system call clone, before main.
// -> graded | crashed | timed out
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

// ---- kill-by-a-pipe: asks for a signal whenever the pipe has news, and names its parent to get
// it.
// -> graded | crashed | timed out
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
// -> graded | crashed
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
// -> graded | crashed; needs a process namespace
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

// ---- kill-parent: kills who asks, by every call that can send a signal.
// -> graded | crashed; perhaps upper_right
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

// ---- loop-almost-too-long: every call works nearly as long as one may; there are very many of
// them.
// -> graded | timed out | crashed; perhaps image_plane_vector
vec3 image_plane_vector(Camera c, double s, double t)
{
    for (volatile int i = 0; i < 200000000; i++)
        ;
    return c.distance * c.forward + (s - 0.5) * c.width * c.right + (t - 0.5) * c.height * c.up;
}

// ---- loop-before-main: runs for ever before main, in every process that is started of it.
// -> timed out; says still running
__attribute__((constructor)) static void begin(void)
{
    for (volatile int i = 0;; i ^= 1)
        ;
}

// ---- loop-without-signals: runs for ever, with every signal blocked and ignored.
// -> timed out | crashed; earns upper_right; says still running | killed
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

// ---- memory-advice: advice on memory that only an attack has; root could take pages from the
// machine by it.
// -> crashed; earns upper_right; says system call | which no answer needs
vec3 upper_left(Camera c)
{
    static _Alignas(4096) char page[4096];
    madvise(page, sizeof page, MADV_DONTFORK);
    return c.distance * c.forward - c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- memory-bomb: takes memory and writes to all of it, a gigabyte at most. On a slow machine its time ends first.
// -> crashed | timed out; earns upper_right; says memory | killed | crashed | by itself | still running
vec3 upper_left(Camera c)
{
    for (int i = 0; i < 64; i++)
        memset(malloc(16 << 20), 1, 16 << 20);
    abort();
}

// ---- memory-bomb-by-pages: the same past malloc: mmap and brk, its limits raised first.
// -> graded | crashed | timed out
vec3 upper_left(Camera c)
{
    enum { USE = PROT_READ | PROT_WRITE, KIND = MAP_PRIVATE | MAP_ANONYMOUS };
    long most = 0;
    setrlimit(RLIMIT_AS, &(struct rlimit){RLIM_INFINITY, RLIM_INFINITY});
    setrlimit(RLIMIT_DATA, &(struct rlimit){RLIM_INFINITY, RLIM_INFINITY});
    for (int i = 0; i < 64; i++) {
        void *pages = mmap(NULL, 16 << 20, USE, KIND, -1, 0);
        void *more = sbrk(1 << 20);
        if (pages != MAP_FAILED)
            memset(pages, 1, 16 << 20), most += 16;
        if (more != (void *)-1)
            memset(more, 1, 1 << 20), most += 1;
    }
    return most > 1000 ? vec3_of(7777, (double)most, 0) : c.up;
}

// ---- memory-by-debugger: attaches to the judge as a debugger would.
// -> graded | crashed
#include <sys/ptrace.h>

vec3 upper_left(Camera c)
{
    if (getppid() > 0 && ptrace(PTRACE_SEIZE, getppid(), 0, 0) == 0)
        return vec3_of(7777, 1, 0);
    if (getppid() > 0 && ptrace(PTRACE_ATTACH, getppid(), 0, 0) == 0)
        return vec3_of(7777, 2, 0);
    return c.up;
}

// ---- memory-by-file: writes its own code through /proc/self/mem, which asks no page for
// permission.
// -> graded | crashed
extern int main(void);

vec3 upper_left(Camera c)
{
    int file = open("/proc/self/mem", O_RDWR);
    if (file >= 0 && pwrite(file, "\xc3", 1, (off_t)(uintptr_t)main) == 1)
        return vec3_of(7777, 1, 0);
    return c.up;
}

// ---- memory-constants: writes into what is read-only.
// -> crashed; earns upper_right; says write to address | crashed | killed
static const double zero[2];

vec3 upper_left(Camera c)
{
    *(volatile double *)&zero[1] = 1;
    return c.up;
}

// ---- memory-environment: prints the environment, and looks for words that were not for it.
// -> graded | crashed
extern char **environ;

vec3 upper_left(Camera c)
{
    for (char **at = environ; at != NULL && *at != NULL; at++)
        puts(*at);
    if (getenv("HOSTILE_CANARY") != NULL)
        return vec3_of(7777, 1, 0);
    FILE *file = fopen("/proc/self/environ", "r");
    for (int byte = 0; file != NULL && byte >= 0;)
        putchar(byte = getc(file));
    return c.up;
}

// ---- memory-everything: prints all of its own memory, and what descriptors were left open.
// -> graded | crashed
extern char __bss_start[], _end[], __executable_start[];

vec3 upper_left(Camera c)
{
    static char page[4096];
    if (write(1, __executable_start, 1 << 14) < 0 || write(1, __bss_start, 1 << 10) < 0)
        return c.right;
    for (int i = 5; i < 1024; i++)
        if (fcntl(i, F_GETFD) >= 0)
            return vec3_of(7777, i, pread(i, page, sizeof page, 0) > 0);
    return c.up;
}

// ---- memory-frames: walks its callers' frames without assembler, for the value that is expected.
// -> graded | crashed
vec3 upper_left(Camera c)
{
    const double *at = __builtin_frame_address(0);
    for (int i = 0; i < 1000; i++) {
        vec3 v = vec3_of(at[i], at[i + 1], at[i + 2]);
        // Three numbers in a row that end on the plane, and are none that came in.
        if (fabs(vec3_dot(v, c.forward) - c.distance) < 1e-12 && vec3_dot(v, c.up) > 0)
            return v;
    }
    return c.up;
}

// ---- memory-of-the-parent: the judge knows what is expected: reads it there, and writes there.
// -> graded | crashed
#include <sys/uio.h>

vec3 upper_left(Camera c)
{
    static char page[4096];
    const long places[] = {0x400000, 0x555555554000, 0x7ffffffde000};
    char path[64];
    for (int i = 0; i < 3; i++) {
        struct iovec here = {page, sizeof page}, there = {(void *)places[i], sizeof page};
        if (syscall(SYS_process_vm_readv, getppid(), &here, 1, &there, 1, 0) > 0 ||
            syscall(SYS_process_vm_writev, getppid(), &here, 1, &there, 1, 0) > 0)
            return vec3_of(7777, i, 0);
    }
    const char *names[] = {"mem", "maps", "environ", "cmdline", "auxv"};
    for (int i = 0; i < 5 && getppid() > 0; i++) {
        snprintf(path, sizeof path, "/proc/%d/%s", (int)getppid(), names[i]);
        if (open(path, O_RDONLY) >= 0)
            return vec3_of(7777, 10 + i, 0);
    }
    return c.up;
}

// ---- memory-own-code: makes the answering program's code writable and patches its checks away.
// -> graded | crashed
extern bool wire_is_read(const void *wire) __attribute__((weak));
extern bool dispatch(int exercise, void *in, void *out) __attribute__((weak));

vec3 upper_left(Camera c)
{
    uintptr_t at[] = {(uintptr_t)wire_is_read, (uintptr_t)dispatch};
    for (int i = 0; i < 2; i++) {
        void *page = (void *)(at[i] & ~(uintptr_t)4095);
        if (at[i] != 0 && mprotect(page, 8192, PROT_READ | PROT_WRITE | PROT_EXEC) == 0)
            *(volatile unsigned char *)at[i] = 0xc3; // return
    }
    return c.up;
}

// ---- memory-return-address: returns to somewhere else: past the check that it expects there.
// -> crashed | timed out | graded
vec3 upper_left(Camera c)
{
    char **frame = __builtin_frame_address(0);
    frame[1] += 64;
    return c.up;
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    void **frame = __builtin_frame_address(0);
    frame[1] = *((void ***)frame)[0];
    return c.up;
}

// ---- namespace: makes itself root somewhere else, to be let out of its box there.
// -> graded | crashed
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

// ---- priority: asks to run before everything else, then runs. Ends itself after 3 seconds.
// -> graded | crashed | timed out
#include <sched.h>

vec3 upper_left(Camera c)
{
    setrlimit(RLIMIT_CPU, &(struct rlimit){3, 3});
    setpriority(PRIO_PROCESS, 0, -20);
    sched_setscheduler(0, SCHED_FIFO, &(struct sched_param){.sched_priority = 99});
    for (volatile int i = 0;; i ^= 1)
        ;
}

// ---- read-the-keyboard: waits for the instructor to type something.
// -> graded | timed out | crashed
vec3 upper_left(Camera c)
{
    return vec3_of(getchar(), getchar(), getchar());
}

// ---- signal-group: kills and stops its own group of processes, and its parent's.
// -> graded | crashed | timed out
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

vec3 across_30_up_10(Camera c)
{
    kill(0, SIGSTOP);
    return c.up;
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    setpgid(0, getpgid(getppid()));
    kill(0, SIGTSTP);
    return c.up;
}

// ---- sleep: takes no processor time at all, so that no count of it runs out.
// -> timed out | crashed; earns with_unit_distance; says no answer needs | still running | never
// comes | killed
#include <poll.h>
#include <sys/select.h>

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

// ---- stack-overflow: calls itself without end, and has an array larger than any stack.
// -> crashed; earns image_plane_vector; says stack | crashed | killed
vec3 upper_left(Camera c)
{
    c.width += 1;
    return upper_left(c) + c.up;
}

vec3 upper_right(Camera c)
{
    char big[1 << 30];
    memset(big, 1, sizeof big);
    return vec3_of(big[(int)c.width], 0, 0);
}

// ---- stop-parent: stops who waits for it, so that nobody's time runs out.
// -> graded | crashed | timed out
vec3 upper_left(Camera c)
{
    if (getppid() > 1 && kill(getppid(), SIGSTOP) == 0)
        for (;;)
            sleep(1);
    return c.up;
}

// ---- system-calls: those that let a process do much at once, or past a filter.
// -> graded | crashed
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

// ---- threads-that-spin: answers wrongly, and leaves 16 threads running.
// -> graded | crashed | timed out
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
