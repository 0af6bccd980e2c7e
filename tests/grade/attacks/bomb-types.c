// bomb-types: structs in structs, each of eight, until their size is no number any more.
// stem: 01-corners
// expect: does not compile | timed out
// earns: nothing
#include "exercises/01-corners.h"
#define S(a, b) typedef struct { b a1[8], a2[8], a3[8], a4[8], a5[8], a6[8], a7[8], a8[8]; } a;
S(A, long) S(B, A) S(C, B) S(D, C) S(E, D) S(F, E) S(G, F) S(H, G) S(I, H) S(J, I) S(K, J)
K big = {.a1[1].a2[1].a3[1].a4[1].a5[1].a6[1].a7[1] = {{0}}};
