// bomb-macro: a few lines that are a thousand million words.
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
