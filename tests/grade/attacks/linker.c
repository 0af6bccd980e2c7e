// linker.c - sections and symbols that give orders to linkers and loaders, or replace names of theirs.

// ---- override-blanks: replaces the notes about blanks, so that a blank is never one.
// -> graded | does not compile | crashed
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
// -> graded | does not compile | crashed | timed out; wrong upper_left
static int yes(void)
{
    return 1;
}
int wire_is_read(void) __attribute__((alias("yes"), weak));
int memchr_(void) __asm__("memchr") __attribute__((alias("yes")));
#pragma weak fflush = yes

// ---- override-by-version: takes the C library's write by its version, from the assembler.
// -> graded | timed out | crashed | does not compile; wrong upper_left
__asm__(".globl write\n.globl poll\nwrite:\npoll:\n ret\n");
long mine(void)
{
    return 0;
}
__asm__(".symver mine,write@GLIBC_2.2.5");

// ---- override-clocks: stops time and chance: clock_gettime, poll, getrandom, alarm, waitpid.
// -> timed out; says still running
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
// -> graded | crashed | timed out; earns upper_right
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

// ---- override-dispatch: defines the answering program's own functions.
// -> does not compile
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
// -> graded | does not compile | crashed
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
// -> does not compile | graded; of 04-pixel-ray
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

// ---- override-libc-start: __libc_start_main, which calls main, and exit, which ends it.
// -> crashed | does not compile
int __libc_start_main(void)
{
    _exit(0);
}

void exit(int status)
{
    _exit(0);
}

// ---- override-main: brings its own main, which reports success.
// -> does not compile
int main(void)
{
    puts("01-corners: 12 passed, 0 failed");
    return 0;
}

// ---- override-main-weakly: a weak main, should no other be there.
// -> graded; earns upper_right
__attribute__((weak)) int main(void)
{
    puts("01-corners: 12 passed, 0 failed");
    return 0;
}

// ---- override-malloc: takes over every allocation, by the linker's names too.
// -> graded | crashed | timed out | does not compile; wrong upper_left
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

// ---- override-mathematics: fabs and sqrt of everything are 0, so that no difference is a
// difference.
// -> graded | does not compile; wrong upper_left
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

// ---- override-memory: memcpy, memcmp and memchr that lie. Its own answers go through them.
// -> graded | crashed | timed out | does not compile; wrong upper_left
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

// ---- override-read: its own read, which hands the answering program the deck's camera every time.
// -> timed out | crashed | does not compile | graded
ssize_t read(int file, void *bytes, size_t size)
{
    memset(bytes, 0, size);
    return (ssize_t)size;
}

vec3 upper_left(Camera c)
{
    return vec3_of(-1, 1, 4);
}

// ---- override-start: the entry point itself, and what runs before and after main.
// -> does not compile
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

// ---- override-write: its own write, which says that it wrote and keeps the answer to itself.
// -> timed out | crashed | does not compile; also upper_right
ssize_t write(int file, const void *bytes, size_t size)
{
    return (ssize_t)size;
}

// ---- pragma-other-name: the answer goes by the reference's name, and another by the answer's.
// -> does not compile | graded
#pragma redefine_extname upper_left reference_upper_left
#pragma redefine_extname upper_right upper_left
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return c.up;
}

// ---- pragma-poison: words that whatever is read after the student's file may not use any more.
// -> does not compile
#pragma GCC poison return vec3 main Camera
#pragma GCC system_header
#pragma GCC diagnostic error "-Weverything"
#pragma GCC visibility push(hidden)

// ---- pragma-target: code for another processor, which passes a vec3 in another way.
// -> graded | crashed | does not compile
#if defined(__x86_64__)
#pragma GCC target("avx512f")
#endif
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return c.up * 2.5;
}

// ---- pragma-weak: one answer for all questions, by weak names.
// -> graded | does not compile | crashed; earns upper_right; bare
#include "exercises/01-corners.h"
#pragma weak upper_left = right
#pragma weak across_30_up_10 = right
#pragma weak image_plane_vector = right
#pragma weak with_unit_distance = right
#pragma weak main = right
#pragma weak dispatch = right

vec3 right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

vec3 upper_right(Camera c)
{
    return right(c);
}

// ---- section-dynamic: entries for the loader: a library and a path of the student's.
// -> crashed | graded | does not compile; perhaps upper_right
__attribute__((section(".dynamic"), used)) static long entries[] = {15, 1, 29, 1, 0x6ffffefc, 1};
__asm__(".section .dynstr,\"a\",@progbits\n.asciz \"\\0/tmp/hostile-was-here.so\"\n.text\n");

// ---- section-for-the-linker: sections in which linkers look for options, and for code to
// optimise.
// -> graded | crashed | does not compile; perhaps upper_right
__asm__(".section .drectve,\"e\",@progbits\n.ascii \" -defaultlib:hostile \"\n"
        ".section .deplibs,\"MS\",@progbits,1\n.asciz \"hostile\"\n"
        ".section .linker-options,\"e\",@progbits\n.asciz \"lib\"\n.asciz \"hostile\"\n"
        ".section .gnu.lto_.opts,\"e\",@progbits\n"
        ".asciz \"'-fplugin=/tmp/hostile-was-here.so' '-wrapper' '/bin/sh,-c,id'\"\n"
        ".section .gnu.lto_upper_left.1,\"e\",@progbits\n.long 1, 2, 3\n"
        ".section .gnu_debuglink,\"\",@progbits\n.asciz \"@TREE@/build/judge\"\n"
        ".text\n");

// ---- section-interpreter: names the program that is to load the answering program.
// -> crashed | graded | does not compile; perhaps upper_right
__attribute__((section(".interp"), used)) static const char loader[] =
    "@TREE@/tests/grade/attacks/no-loader";

// ---- section-notes: forged notes: a stack that may be run, processor features, a build id.
// -> graded | crashed | does not compile; perhaps upper_right
__asm__(".section .note.gnu.property,\"a\",@note\n.long 4, 16, 5\n.asciz \"GNU\"\n"
        ".long 0xc0000002, 4, 0xffffffff, 0\n"
        ".section .note.gnu.build-id,\"a\",@note\n.long 4, 4, 3\n.asciz \"GNU\"\n.long 0\n"
        ".section .note.GNU-stack,\"x\",@progbits\n.text\n");

// ---- section-start: code in the sections that run at the start, written out by hand.
// -> crashed | graded | does not compile
#if defined(__x86_64__)
__asm__(".section .init,\"ax\",@progbits\n mov $231, %eax\n xor %edi, %edi\n syscall\n"
        ".section .ctors,\"aw\",@progbits\n .quad 1\n"
        ".section .init_array.00001,\"aw\",@init_array\n .quad leave\n"
        ".text\nleave: mov $231, %eax\n xor %edi, %edi\n syscall\n");
#else
__attribute__((section(".ctors"), used)) static void *const first = (void *)1;
#endif
