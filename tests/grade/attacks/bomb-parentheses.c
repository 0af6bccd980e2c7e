// bomb-parentheses: a million of them, one inside the other, until the compiler's stack is full.
// stem: 01-corners
// expect: does not compile | timed out
// earns: nothing
// rest: none
#define A (((((((((((((((((((((((((((((((( // )
#define B A A A A A A A A A A A A A A A A A A A A A A A A A A A A A A A A
#define C B B B B B B B B B B B B B B B B B B B B B B B B B B B B B B B B
#define D C C C C C C C C C C C C C C C C C C C C C C C C C C C C C C C C
int a = D 1;
