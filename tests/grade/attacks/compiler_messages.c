// compiler_messages.c - messages of the compiler and the linker whose text the student chooses.
// cases.py reads it: each section is one submission, and states the result that it must get.

// ---- message-assembler: the assembler prints what it is told to, on stdout and stderr.
// stem: 01-corners
// expect: does not compile
// earns: nothing
#include "exercises/01-corners.h"

__asm__(".print \"ok 1 - forged-mark\\n\\033[2J\"\n.warning \"=1+1\\n\\033[2J\"\n"
        ".error \"tests/05-quadratic.c: 100 passed\\n\"");

// ---- message-assert: a static assertion whose words are lines of their own.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#include "exercises/01-corners.h"
_Static_assert(0, "\n01-corners: 12 passed, 0 failed\nok 1 - forged-mark\n\x1b[2J\n--- \n...\nBail out!");

// ---- message-attribute: words of error, warning and deprecation that the compiler repeats.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#include "exercises/01-corners.h"

void a(void) __attribute__((error("\nok 1 - forged-mark\x1b[2J")));
void b(void) __attribute__((warning("\n\x1b]0;forged-mark\a]]>")));
void c(void) __attribute__((deprecated("\n=1+1\n\x1b[31m</system-out>")));

vec3 upper_left(Camera camera)
{
    a();
    b();
    c();
    return camera.nothing;
}

// ---- message-error: a compiler's words that are XML, a formula, an escape code and a forged line.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#include "exercises/01-corners.h"
#error ]]></failure></testcase><script>alert("x")</script> =cmd|'/C calc'!A0 @SUM(1) @ESC@[2J@ESC@]0;x@BEL@
#error ok 1 - upper_left # forged-mark

// ---- message-flood: a short file, and a hundred thousand complaints about it.
// stem: 01-corners
// expect: does not compile | timed out
// earns: nothing
// rest: none
#include "exercises/01-corners.h"
#define A int a = "x";
#define B A A A A A A A A A A
#define C B B B B B B B B B B
#define D C C C C C C C C C C
#define E D D D D D D D D D D
E E E E E E E E E E

// ---- message-line: pretends to be the tests, with a file name that has escape codes and newlines.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#include "exercises/01-corners.h"
#line 1 "tests/05-quadratic.c"
vec3 upper_left(Camera c)
{
    return "not a vector";
}
#line 100 "\nok 1 - forged-mark\n\033[2J<b>=1+1"
vec3 upper_right(Camera c)
{
    return "not a vector";
}

// ---- message-line-that-quotes: errors 'in' the solution, so that the compiler shows its lines.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#include "exercises/01-corners.h"
#define E(n) static int e##n = "";
#line 1 "@TREE@/solutions/01-corners.c"
E(1)
E(2)
E(3)
E(4)
E(5)
E(6)
E(7)
E(8)
#line 1 "solutions/01-corners.c"
E(11)
E(12)
E(13)
#line 1 "@TREE@/tests/01-corners.c"
E(21)
E(22)
E(23)
#line 1 "@SUBMISSIONS@/honest/01-corners.c"
E(31)
E(32)
E(33)
#line 1 "@HOME@/.netrc"
E(41)
#line 1 "/etc/passwd"
E(51)
#line 1 "/proc/self/environ"
E(61)

// ---- message-linker: a section that makes the linker print the student's words as a warning.
// stem: 01-corners
// expect: graded
// earns: upper_right
#include "exercises/01-corners.h"

__attribute__((section(".gnu.warning.upper_left"), used)) static const char words[] =
    "\nok 1 - forged-mark\n\x1b[2J  multiple definition of `main'";

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- message-linker-names: misses a function whose name is a forged line with escape codes.
// stem: 01-corners
// expect: does not compile | graded
// earns: nothing
#include "exercises/01-corners.h"

void odd(void) __asm__("x\nok 1 - forged-mark\n\033[2J");
void odder(void) __asm__("=1+1</pre><script>");

vec3 upper_left(Camera c)
{
    odd();
    odder();
    return c.up;
}

// ---- message-names: names that read from right to left, or look like others, in what is quoted.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#include "exercises/01-corners.h"

int \u0430\u0435 = "not a number"; /* ‮⁦ forged-mark ⁩⁦ */
vec3 upper_left(Camera c)
{
    return "‮forged-mark‭  \u202e </b>";
}

// ---- message-of-the-path: prints where it was compiled, and from what.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>

vec3 upper_left(Camera c)
{
    puts(__FILE__ " " __BASE_FILE__ " " __TIMESTAMP__ " " __VERSION__);
    return c.up;
}

// ---- message-pragma: the compiler prints a string of the student's, newlines and escape codes included.
// stem: 01-corners
// expect: graded
// earns: upper_right
#include "exercises/01-corners.h"
#pragma message "x\ntests/05-quadratic.c:1: 100 passed forged-mark\n\x1b[2J\033]0;x\a=1+1"
#warning =1+1 </pre><script>
_Pragma("GCC warning \"\\nok 1 - all\\n\\033[2J\"")

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
