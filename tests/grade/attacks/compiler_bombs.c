// compiler_bombs.c - short texts for which the compiler needs endless memory, time or disk.
// cases.py reads it: each section is one submission, and states the result that it must get.

// ---- bomb-array: an array larger than the machine, which needs no room until it is touched.
// stem: 01-corners
// expect: does not compile | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"

char big[1ull << 40];

vec3 upper_left(Camera c)
{
    big[1ull << 39] = 1;
    return c.up;
}

// ---- bomb-assembler: repeats a line for the assembler a thousand million times.
// stem: 01-corners
// expect: does not compile | timed out
// earns: nothing
#include "exercises/01-corners.h"

__asm__(".data\n.rept 1000000000\n.quad 1, 2, 3, 4\n.endr\n.text\n");

// ---- bomb-assembler-room: has the assembler write a terabyte of zeros.
// stem: 01-corners
// expect: does not compile | timed out
// earns: nothing
#include "exercises/01-corners.h"

__asm__(".data\n.fill 1000000000000, 1, 7\n.balign 1 << 30\n.quad 1\n.text\n");

// ---- bomb-braces: a hundred thousand blocks, one inside the other.
// stem: 01-corners
// expect: does not compile | timed out
// earns: nothing
// rest: none
#define A {{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{
#define B A A A A A A A A A A A A A A A A A A A A A A A A A A A A A A A A
#define C B B B B B B B B B B B B B B B B B B B B B B B B B B B B B B B B
void f(void)
C C C

// ---- bomb-file: two gigabytes that have to be written out.
// stem: 01-corners
// expect: does not compile | timed out
// earns: nothing
#include "exercises/01-corners.h"

char big[2147483647] = {1};

vec3 upper_left(Camera c)
{
    return vec3_of(big[1], 0, 0);
}

// ---- bomb-itself: includes itself, twice, to the depth that compilers allow.
// stem: 01-corners
// expect: does not compile | timed out
// earns: nothing
// rest: none
#include __FILE__
#include __FILE__

// ---- bomb-macro: a few lines that are a thousand million words.
// stem: 01-corners
// expect: does not compile | timed out
// earns: nothing
// rest: none
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

// ---- bomb-parentheses: a million of them, one inside the other, until the compiler's stack is full.
// stem: 01-corners
// expect: does not compile | timed out
// earns: nothing
// rest: none
#define A (((((((((((((((((((((((((((((((( // )
#define B A A A A A A A A A A A A A A A A A A A A A A A A A A A A A A A A
#define C B B B B B B B B B B B B B B B B B B B B B B B B B B B B B B B B
#define D C C C C C C C C C C C C C C C C C C C C C C C C C C C C C C C C
int a = D 1;

// ---- bomb-paste: names that are pasted together until each is a megabyte long.
// stem: 01-corners
// expect: does not compile | timed out | graded
// earns: nothing
// rest: none
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
// stem: 01-corners
// expect: does not compile | timed out
// earns: nothing
#include "exercises/01-corners.h"
#define A "xxxxxxxxxxxxxxxx" "xxxxxxxxxxxxxxxx" "xxxxxxxxxxxxxxxx" "xxxxxxxxxxxxxxxx"
#define B A A A A A A A A A A A A A A A A
#define C B B B B B B B B B B B B B B B B
#define D C C C C C C C C C C C C C C C C
#define E D D D D D D D D D D D D D D D D
#define F E E E E E E E E E E E E E E E E
#define G F F F F

const char *const words = G;

// ---- bomb-types: structs in structs, each of eight, until their size is no number any more.
// stem: 01-corners
// expect: does not compile | timed out
// earns: nothing
#include "exercises/01-corners.h"
#define S(a, b) typedef struct { b a1[8], a2[8], a3[8], a4[8], a5[8], a6[8], a7[8], a8[8]; } a;
S(A, long) S(B, A) S(C, B) S(D, C) S(E, D) S(F, E) S(G, F) S(H, G) S(I, H) S(J, I) S(K, J)
K big = {.a1[1].a2[1].a3[1].a4[1].a5[1].a6[1].a7[1] = {{0}}};
