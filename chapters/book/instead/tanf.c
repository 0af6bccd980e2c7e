// tanf, rounded correctly: that of WebAssembly's C library is not for 13 in 100 of the angles below
// 90 degrees, which changes the last digit of a verdict. In the terminal it depends on the C
// library: glibc's is rounded correctly since 2.41; before that 4 in 100 are not.
#include <math.h>

float tanf(float angle)
{
    return (float)tan((double)angle);
}
