// compiler.c - texts for which the compiler needs endless memory, time or disk, or whose messages are forged.

// ---- bomb-array: an array larger than the machine, which needs no room until it is touched.
// -> does not compile | crashed | timed out
char big[1ull << 40];

vec3 upper_left(Camera c)
{
    big[1ull << 39] = 1;
    return c.up;
}

// ---- bomb-assembler: repeats a line for the assembler a thousand million times.
// -> does not compile | timed out
__asm__(".data\n.rept 1000000000\n.quad 1, 2, 3, 4\n.endr\n.text\n");

// ---- bomb-braces: a hundred thousand blocks, one inside the other.
// -> does not compile | timed out; bare
#define A {{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{
#define B A A A A A A A A A A A A A A A A A A A A A A A A A A A A A A A A
#define C B B B B B B B B B B B B B B B B B B B B B B B B B B B B B B B B
void f(void)
C C C

// ---- bomb-file: two gigabytes that have to be written out.
// -> does not compile | timed out
char big[2147483647] = {1};

vec3 upper_left(Camera c)
{
    return vec3_of(big[1], 0, 0);
}

// ---- bomb-itself: includes itself, twice, to the depth that compilers allow.
// -> does not compile | timed out; bare
#include __FILE__
#include __FILE__

// ---- bomb-macro: a few lines that are a thousand million words.
// -> does not compile | timed out; bare
#define A x, x, x, x, x, x, x, x
#define B A, A, A, A, A, A, A, A
#define C B, B, B, B, B, B, B, B
#define D C, C, C, C, C, C, C, C
#define E D, D, D, D, D, D, D, D
#define F E, E, E, E, E, E, E, E
#define G F, F, F, F, F, F, F, F
#define H G, G, G, G, G, G, G, G
#define I H, H, H, H, H, H, H, H
#define J I, I, I, I, I, I, I, I
int J;

// ---- bomb-parentheses: a million of them, one inside the other, until the compiler's stack is
// full.
// -> does not compile | timed out; bare
#define A (((((((((((((((((((((((((((((((( // )
#define B A A A A A A A A A A A A A A A A A A A A A A A A A A A A A A A A
#define C B B B B B B B B B B B B B B B B B B B B B B B B B B B B B B B B
#define D C C C C C C C C C C C C C C C C C C C C C C C C C C C C C C C C
int a = D 1;

// ---- bomb-paste: names that are pasted together until each is a megabyte long.
// -> does not compile | timed out | graded; bare
#define P(a, b) P2(a, b)
#define P2(a, b) a##b
#define A aaaaaaaaaaaaaaaa
#define B P(P(P(A, A), P(A, A)), P(P(A, A), P(A, A)))
#define C P(P(P(B, B), P(B, B)), P(P(B, B), P(B, B)))
#define D P(P(P(C, C), P(C, C)), P(P(C, C), P(C, C)))
#define E P(P(P(D, D), P(D, D)), P(P(D, D), P(D, D)))
#define F P(P(P(E, E), P(E, E)), P(P(E, E), P(E, E)))
#define G(n) int P(F, n);
G(0) G(1) G(2) G(3) G(4) G(5) G(6) G(7) G(8) G(9)

// ---- bomb-string: one string constant of a quarter of a gigabyte.
// -> does not compile | timed out
#define A "xxxxxxxxxxxxxxxx" "xxxxxxxxxxxxxxxx" "xxxxxxxxxxxxxxxx" "xxxxxxxxxxxxxxxx"
#define B A A A A A A A A A A A A A A A A
#define C B B B B B B B B B B B B B B B B
#define D C C C C C C C C C C C C C C C C
#define E D D D D D D D D D D D D D D D D
#define F E E E E E E E E E E E E E E E E
#define G F F F F

const char *const words = G;

// ---- message-assembler: the assembler prints what it is told to, on stdout and stderr.
// -> does not compile
__asm__(".print \"ok 1 - forged-mark\\n\\033[2J\"\n.warning \"=1+1\\n\\033[2J\"\n"
        ".error \"tests/05-quadratic.c: 100 passed\\n\"");

// ---- message-assert: a static assertion whose words are lines of their own.
// -> does not compile; bare
#include "exercises/01-corners.h"
_Static_assert(0, "\n01-corners: 12 passed, 0 failed\nok 1 - forged-mark\n\x1b[2J\n--- \n...\nBail out!");

// ---- message-error: a compiler's words that are XML, a formula, an escape code and a forged line.
// -> does not compile; bare
#include "exercises/01-corners.h"
#error ]]></failure></testcase><script>alert("x")</script> =cmd|'/C calc'!A0 @SUM(1) @ESC@[2J@ESC@]0;x@BEL@
#error ok 1 - upper_left # forged-mark

// ---- message-flood: a short file, and a hundred thousand complaints about it.
// -> does not compile | timed out; bare
#include "exercises/01-corners.h"
#define A int a = "x";
#define B A A A A A A A A A A
#define C B B B B B B B B B B
#define D C C C C C C C C C C
#define E D D D D D D D D D D
E E E E E E E E E E

// ---- message-line: pretends to be the tests, with a file name that has escape codes and newlines.
// -> does not compile; bare
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
// -> does not compile; bare
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
// -> graded; earns upper_right
__attribute__((section(".gnu.warning.upper_left"), used)) static const char words[] =
    "\nok 1 - forged-mark\n\x1b[2J  multiple definition of `main'";

// ---- message-linker-names: misses a function whose name is a forged line with escape codes.
// -> does not compile | graded
void odd(void) __asm__("x\nok 1 - forged-mark\n\033[2J");
void odder(void) __asm__("=1+1</pre><script>");

vec3 upper_left(Camera c)
{
    odd();
    odder();
    return c.up;
}

// ---- message-names: names that read from right to left, or look like others, in what is quoted.
// -> does not compile; bare
#include "exercises/01-corners.h"

int \u0430\u0435 = "not a number"; /* ‮⁦ forged-mark ⁩⁦ */
vec3 upper_left(Camera c)
{
    return "‮forged-mark‭  \u202e </b>";
}

// ---- message-of-the-path: prints where it was compiled, and from what.
// -> graded
vec3 upper_left(Camera c)
{
    puts(__FILE__ " " __BASE_FILE__ " " __TIMESTAMP__ " " __VERSION__);
    return c.up;
}

// ---- message-pragma: the compiler prints a string of the student's, newlines and escape codes
// included.
// -> graded; earns upper_right
#pragma message "x\ntests/05-quadratic.c:1: 100 passed forged-mark\n\x1b[2J\033]0;x\a=1+1"
#warning =1+1 </pre><script>
_Pragma("GCC warning \"\\nok 1 - all\\n\\033[2J\"")
