// exit-into-main: answers by running the answering program's main once more, inside itself.
// stem: 01-corners
// expect: crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"

extern int main(void);

vec3 upper_left(Camera c)
{
    main();
    return c.up;
}
