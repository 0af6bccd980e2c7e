// bomb-paste: names that are pasted together until each is a megabyte long.
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
