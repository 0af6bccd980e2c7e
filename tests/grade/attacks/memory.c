// memory.c - too much memory, the judge's memory, and memory that must not be read or written.
// cases.py reads it: each section is one submission, and states the result that it must get.

// ---- memory-bomb: takes memory and writes to all of it, a gigabyte at most.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: memory | killed | crashed | by itself
#include "exercises/01-corners.h"
#include <stdlib.h>
#include <string.h>

vec3 upper_left(Camera c)
{
    for (int i = 0; i < 64; i++)
        memset(malloc(16 << 20), 1, 16 << 20);
    abort();
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- memory-bomb-by-pages: the same past malloc: mmap and brk, its limits raised first.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

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

// ---- memory-bomb-on-the-stack: an array larger than any stack.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: stack | crashed | killed
#include "exercises/01-corners.h"
#include <string.h>

vec3 upper_left(Camera c)
{
    char big[1 << 30];
    memset(big, 1, sizeof big);
    return vec3_of(big[(int)c.width], 0, 0);
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- memory-by-debugger: attaches to the judge as a debugger would.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <sys/ptrace.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    if (getppid() > 0 && ptrace(PTRACE_SEIZE, getppid(), 0, 0) == 0)
        return vec3_of(7777, 1, 0);
    if (getppid() > 0 && ptrace(PTRACE_ATTACH, getppid(), 0, 0) == 0)
        return vec3_of(7777, 2, 0);
    return c.up;
}

// ---- memory-by-file: writes its own code through /proc/self/mem, which asks no page for permission.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <stdint.h>
#include <unistd.h>

extern int main(void);

vec3 upper_left(Camera c)
{
    int file = open("/proc/self/mem", O_RDWR);
    if (file >= 0 && pwrite(file, "\xc3", 1, (off_t)(uintptr_t)main) == 1)
        return vec3_of(7777, 1, 0);
    return c.up;
}

// ---- memory-constants: writes into what is read-only.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: write to address | crashed | killed
#include "exercises/01-corners.h"

static const double zero[2];

vec3 upper_left(Camera c)
{
    *(volatile double *)&zero[1] = 1;
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- memory-environment: prints the environment, and looks for words that were not for it.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>
#include <stdlib.h>

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
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

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
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"

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
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <stdio.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

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
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <stdbool.h>
#include <stdint.h>
#include <sys/mman.h>

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
// stem: 01-corners
// expect: crashed | timed out | graded
// earns: nothing
#include "exercises/01-corners.h"

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
