// message-attribute: words of error, warning and deprecation that the compiler repeats.
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
