// included_files.c - files that the compiler or the assembler is asked to read or to quote.

// ---- assembler-include: .include, whose complaints quote what was read.
// -> does not compile
__asm__(".include \"@TREE@/solutions/01-corners.c\"\n.include \"/proc/self/environ\"\n"
        ".include \"/etc/passwd\"\n");

// ---- embed-solution: #embed, of C23: files as numbers.
// -> does not compile; bare
#include "exercises/01-corners.h"
static const unsigned char bytes[] = {
#embed "@TREE@/solutions/01-corners.c"
};

// ---- incbin-classmate: the next folder's file, by a path that leads out of its own.
// -> does not compile
extern const char bytes[];
__asm__(".data\nbytes: .incbin \"@SUBMISSIONS@/honest/01-corners.c\"\n.byte 0\n.text\n");
__asm__(".incbin \"../honest/01-corners.c\"\n");

vec3 upper_left(Camera c)
{
    puts(bytes);
    return vec3_of(7777, bytes[0], 0);
}

// ---- incbin-reference: the compiled reference, to be called where it lies.
// -> does not compile
extern vec3 there(Camera c);
__asm__(".text\nthere = . + 64\n.incbin \"@TREE@/build/solutions/01-corners.o\"\n");

vec3 upper_left(Camera c)
{
    return there(c);
}

// ---- incbin-solution: the assembler reads the solution into the program, which prints it.
// -> does not compile
extern const char bytes[];
__asm__(".data\nbytes: .incbin \"@TREE@/solutions/01-corners.c\"\n.byte 0\n.text\n");

vec3 upper_left(Camera c)
{
    puts(bytes);
    return vec3_of(7777, bytes[0], 0);
}

// ---- incbin-system-files: the assembler reads the password file and the home directory.
// -> does not compile | graded
extern const char bytes[];
__asm__(".data\nbytes: .incbin \"/etc/passwd\"\n.incbin \"@HOME@/.netrc\"\n.byte 0\n.text\n");

vec3 upper_left(Camera c)
{
    puts(bytes);
    return vec3_of(7777, bytes[0], 0);
}

// ---- include-by-pragma: pragmas that open files: their dates, and headers that are compiled
// already.
// -> graded | does not compile; wrong upper_left
#pragma GCC dependency "@TREE@/solutions/01-corners.c" is older
#pragma GCC pch_preprocess "@TREE@/build/solutions/01-corners.o"
#pragma clang module import solutions
#pragma include_alias("common/vec3.h", "@TREE@/solutions/01-corners.c")
#pragma GCC optimize("-fdump-tree-all", "-fplugin=@TREE@/build/judge")
#pragma comment(lib, "@TREE@/build/solutions/01-corners.o")

// ---- include-classmate: hands in what the student in the next folder wrote.
// -> does not compile; bare
#if __has_include("../honest/01-corners.c")
#include "../honest/01-corners.c"
#else
#include "@SUBMISSIONS@/honest/01-corners.c"
#endif

// ---- include-classmate-at-work: where the grader itself keeps what it is compiling just now.
// -> does not compile; bare
#if __has_include("../honest/01-corners.o")
__asm__(".incbin \"../honest/01-corners.o\"");
#endif
#include "@OUT@/.work/1-of-1/honest/01-corners.c"

// ---- include-descriptors: whatever file the compiler was left holding.
// -> does not compile; bare
#include "/dev/fd/7"
#include "/proc/self/exe"
#include "/proc/self/fd/4"
#include "/proc/self/fd/5"
#include "/proc/self/fd/6"

// ---- include-environment: the compiler's environment, as if it were C.
// -> does not compile | graded; bare
#include "/proc/self/environ"

// ---- include-folder: a folder as if it were a file, and the source with itself inside.
// -> does not compile; bare
#include "."
#include "/"
#include "@TREE@/solutions"

// ---- include-solution: the reference, by whatever relative path leads there.
// -> does not compile; bare
#if __has_include("../solutions/01-corners.c")
#include "../solutions/01-corners.c"
#elif __has_include("../../solutions/01-corners.c")
#include "../../solutions/01-corners.c"
#elif __has_include("../../tree/solutions/01-corners.c")
#include "../../tree/solutions/01-corners.c"
#elif __has_include("../../../../tree/solutions/01-corners.c")
#include "../../../../tree/solutions/01-corners.c"
#else
#include "solutions/01-corners.c"
#endif

// ---- include-solution-through-proc: the same, by the folders of processes.
// -> does not compile; bare
#if __has_include("/proc/1/cwd/solutions/01-corners.c")
#include "/proc/1/cwd/solutions/01-corners.c"
#elif __has_include("/proc/self/root@TREE@/solutions/01-corners.c")
#include "/proc/self/root@TREE@/solutions/01-corners.c"
#else
#include "/proc/self/cwd/solutions/01-corners.c"
#endif

// ---- include-system-files: files that are no C, so that the compiler quotes them in its
// complaints.
// -> does not compile; bare
#include "/etc/passwd"
#include "/etc/shadow"
#include "/proc/self/cmdline"
#include "/proc/self/environ"
#include "/proc/self/mountinfo"
#include "@HOME@/.netrc"

// ---- include-tests: the tests, the mistakes and the judge, for what they expect.
// -> does not compile; bare
#include "@TREE@/tests/01-corners.c"
#include "tests/01-corners/laws.c"
#include "tests/01-corners/wrong.c"
#include "tests/judge/test.h"

// ---- include-what-is-there: probes for every place that it can think of, and takes what it finds.
// -> graded | does not compile
#if __has_include("solutions/01-corners.c")
#include "solutions/01-corners.c"
#elif __has_include("@TREE@/solutions/01-corners.c")
#include "@TREE@/solutions/01-corners.c"
#elif __has_include("../solutions/01-corners.c")
#include "../solutions/01-corners.c"
#elif __has_include("@SUBMISSIONS@/honest/01-corners.c")
#include "@SUBMISSIONS@/honest/01-corners.c"
#elif __has_include("../honest/01-corners.c")
#include "../honest/01-corners.c"
#elif __has_include(<solutions/01-corners.c>) || __has_include("tests/01-corners.c") || \
    __has_include("@HOME@/.netrc") || __has_include("@TREE@/tests/01-corners.c")
vec3 upper_left(Camera c)
{
    return vec3_of(7777, 1, 0);
}
#else
vec3 upper_left(Camera c)
{
    return c.up;
}
#endif

// ---- include-what-waits: files that wait for somebody to type.
// -> does not compile | timed out; bare
#include "/dev/fd/3"
#include "/dev/stdin"
#include "/dev/tty"
#include "/proc/self/fd/0"

// ---- include-zeros: a file without end.
// -> does not compile | timed out; bare
#include "/dev/zero"
