// c-plus-plus: another language.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#include <iostream>
template <class T> T upper_left(T c) { std::cout << "forged-mark"; return c; }
