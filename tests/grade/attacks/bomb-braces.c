// bomb-braces: a hundred thousand blocks, one inside the other.
// stem: 01-corners
// expect: does not compile | timed out
// earns: nothing
// rest: none
#define A {{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{
#define B A A A A A A A A A A A A A A A A A A A A A A A A A A A A A A A A
#define C B B B B B B B B B B B B B B B B B B B B B B B B B B B B B B B B
void f(void)
C C C
