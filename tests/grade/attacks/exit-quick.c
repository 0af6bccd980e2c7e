// exit-quick: quick_exit(0), the third way out of a program.
// stem: 01-corners
// expect: crashed
// earns: nothing
// says: by itself | was killed | no answer
#include "exercises/01-corners.h"
#include <stdlib.h>

vec3 upper_left(Camera c)
{
    quick_exit(0);
}
