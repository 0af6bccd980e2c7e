// replaced_symbols.c - names that replace those of the answering program, the C library or the linker.
// cases.py reads it: each section is one submission, and states the result that it must get.

// ---- override-blanks: replaces the notes about blanks, so that a blank is never one.
// stem: 01-corners
// expect: graded | does not compile | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <string.h>

void *not_answered(const char *function, const char *file, void *value, size_t size)
{
    return memset(value, 0, size);
}

int answers_missing(void)
{
    return 0;
}

const char *answer_missing(int i)
{
    return "";
}

void answers_forget(void)
{
}

int answers_report(void)
{
    return 0;
}

// ---- override-by-alias: one function under many names, and other names for those asked for.
// stem: 01-corners
// expect: graded | does not compile | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"

static int yes(void)
{
    return 1;
}
int wire_is_read(void) __attribute__((alias("yes"), weak));
int memchr_(void) __asm__("memchr") __attribute__((alias("yes")));
#pragma weak fflush = yes

vec3 upper_left(Camera c)
{
    return c.up;
}

// ---- override-by-version: takes the C library's write by its version, from the assembler.
// stem: 01-corners
// expect: graded | timed out | crashed | does not compile
// earns: nothing
#include "exercises/01-corners.h"

__asm__(".globl write\n.globl poll\nwrite:\npoll:\n ret\n");
long mine(void)
{
    return 0;
}
__asm__(".symver mine,write@GLIBC_2.2.5");

vec3 upper_left(Camera c)
{
    return c.up;
}

// ---- override-check: Check's functions that count what failed.
// stem: 01-corners
// expect: graded
// earns: upper_right
#include "exercises/01-corners.h"

void ck_assert_failed(const char *file, int line, const char *words, ...)
{
}

void _ck_assert_failed(const char *file, int line, const char *words, ...)
{
}

int srunner_ntests_failed(void *runner)
{
    return 0;
}

void mark_point(void)
{
}

vec3 upper_left(Camera c)
{
    ck_assert_failed("", 0, "");
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- override-clocks: stops time and chance: clock_gettime, poll, getrandom, alarm, waitpid.
// stem: 01-corners
// expect: timed out
// earns: nothing
// says: still running
#include "exercises/01-corners.h"
#include <time.h>

int clock_gettime(clockid_t clock, struct timespec *time)
{
    *time = (struct timespec){0};
    return 0;
}

long getrandom(void *bytes, size_t size, unsigned flags)
{
    return (long)size;
}

int poll(void *files, unsigned long count, int most)
{
    return 1;
}

vec3 upper_left(Camera c)
{
    for (volatile int i = 0;; i ^= 1)
        ;
}

// ---- override-crash-handler: catches its own crash and goes on as if it had answered.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: upper_right
#include "exercises/01-corners.h"
#include <setjmp.h>
#include <signal.h>

static sigjmp_buf before;

static void back(int number)
{
    siglongjmp(before, 1);
}

vec3 upper_left(Camera c)
{
    signal(SIGSEGV, back);
    if (sigsetjmp(before, 1) == 0)
        *(volatile int *)8 = 1;
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- override-dispatch: defines the answering program's own functions.
// stem: 01-corners
// expect: does not compile
// earns: nothing
#include "exercises/01-corners.h"
#include <stdbool.h>

bool dispatch(int exercise, void *in, void *out)
{
    return true;
}

void wire_put(void *wire, const void *value, size_t size)
{
}

bool wire_is_read(const void *wire)
{
    return true;
}

// ---- override-dispatch-weakly: the same as data, as common blocks, and weak, where that may pass.
// stem: 01-corners
// expect: graded | does not compile | crashed
// earns: nothing
#include "exercises/01-corners.h"

__attribute__((common)) char dispatch[4096];
__attribute__((weak)) char wire_get[4096];
__attribute__((weak)) void wire_put(void)
{
}
static char target[16];
extern char wire_clear[16] __attribute__((weak, alias("target")));

vec3 upper_left(Camera c)
{
    return vec3_of(dispatch[0], target[0], wire_get[0]);
}

// ---- override-earlier: a later chapter that defines an earlier one's function, strongly.
// stem: 04-pixel-ray
// expect: does not compile | graded
// earns: nothing
#include "exercises/04-pixel-ray.h"

vec3 image_plane_vector(Camera c, double s, double t)
{
    return c.up;
}
__asm__(".globl screen_to_normalized\nscreen_to_normalized:\n ret\n"
        ".globl pixel_center\npixel_center:\n ret\n");

Ray pixel_ray(Camera camera, Resolution screen, Pixel pixel)
{
    return (Ray){camera.origin, image_plane_vector(camera, 0, 0)};
}

// ---- override-later: chapter 01 brings all of 05 and 06, wrong, in the hope that they meet.
// stem: 01-corners
// expect: graded
// earns: upper_right
#include "exercises/01-corners.h"

double hit_sphere(void)
{
    return 1;
}

int nearest_hit(void)
{
    return 0;
}

vec3 reference_hit_sphere(void)
{
    return (vec3){0};
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- override-libc-start: __libc_start_main, which calls main, and exit, which ends it.
// stem: 01-corners
// expect: crashed | does not compile
// earns: nothing
#include "exercises/01-corners.h"
#include <stdlib.h>
#include <unistd.h>

int __libc_start_main(void)
{
    _exit(0);
}

void exit(int status)
{
    _exit(0);
}

// ---- override-main: brings its own main, which reports success.
// stem: 01-corners
// expect: does not compile
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>

int main(void)
{
    puts("01-corners: 12 passed, 0 failed");
    return 0;
}

// ---- override-main-weakly: a weak main, should no other be there.
// stem: 01-corners
// expect: graded
// earns: upper_right
#include "exercises/01-corners.h"
#include <stdio.h>

__attribute__((weak)) int main(void)
{
    puts("01-corners: 12 passed, 0 failed");
    return 0;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- override-malloc: takes over every allocation, by the linker's names too.
// stem: 01-corners
// expect: graded | crashed | timed out | does not compile
// earns: nothing
#include "exercises/01-corners.h"
#include <stdlib.h>

void *malloc(size_t size)
{
    return NULL;
}

void *__real_malloc(size_t size)
{
    return NULL;
}

void free(void *memory)
{
}

vec3 upper_left(Camera c)
{
    return c.up;
}

// ---- override-mathematics: fabs and sqrt of everything are 0, so that no difference is a difference.
// stem: 01-corners
// expect: graded | does not compile
// earns: nothing
#include "exercises/01-corners.h"

double fabs(double x)
{
    return 0;
}

double sqrt(double x)
{
    return 0;
}

double fmax(double x, double y)
{
    return 0;
}

vec3 upper_left(Camera c)
{
    return c.up;
}

// ---- override-memory: memcpy, memcmp and memchr that lie. Its own answers go through them.
// stem: 01-corners
// expect: graded | crashed | timed out | does not compile
// earns: nothing
#include "exercises/01-corners.h"
#include <string.h>

void *memcpy(void *restrict to, const void *restrict from, size_t size)
{
    for (size_t i = 0; i < size; i++)
        ((volatile char *)to)[i] = 0;
    return to;
}

int memcmp(const void *a, const void *b, size_t size)
{
    return 0;
}

void *memchr(const void *in, int what, size_t size)
{
    return NULL;
}

vec3 upper_left(Camera c)
{
    return c.up;
}

// ---- override-read: its own read, which hands the answering program the deck's camera every time.
// stem: 01-corners
// expect: timed out | crashed | does not compile | graded
// earns: nothing
#include "exercises/01-corners.h"
#include <string.h>
#include <unistd.h>

ssize_t read(int file, void *bytes, size_t size)
{
    memset(bytes, 0, size);
    return (ssize_t)size;
}

vec3 upper_left(Camera c)
{
    return vec3_of(-1, 1, 4);
}

// ---- override-reference: defines the reference, so that the wrong answer is what is expected.
// stem: 01-corners
// expect: graded | does not compile
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return c.up;
}

vec3 reference_upper_left(Camera c)
{
    return c.up;
}

vec3 reference_upper_right(Camera c)
{
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.up;
}

// ---- override-start: the entry point itself, and what runs before and after main.
// stem: 01-corners
// expect: does not compile
// earns: nothing
#include "exercises/01-corners.h"
#include <unistd.h>

void _start(void)
{
    _exit(0);
}

void _init(void)
{
    _exit(0);
}

void _fini(void)
{
    _exit(0);
}

// ---- override-wrap: defines what the linker's --wrap looks for.
// stem: 01-corners
// expect: does not compile | graded
// earns: nothing
#include "exercises/01-corners.h"
#include <stdlib.h>

void *__wrap_malloc(size_t size)
{
    exit(0);
}

void *__wrap_calloc(size_t count, size_t size)
{
    exit(0);
}

vec3 upper_left(Camera c)
{
    return c.up;
}

// ---- override-write: its own write, which says that it wrote and keeps the answer to itself.
// stem: 01-corners
// expect: timed out | crashed | does not compile
// earns: nothing
#include "exercises/01-corners.h"
#include <unistd.h>

ssize_t write(int file, const void *bytes, size_t size)
{
    return (ssize_t)size;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
