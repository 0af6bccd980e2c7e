// message-names: names that read from right to left, or look like others, in what is quoted.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#include "exercises/01-corners.h"

int \u0430\u0435 = "not a number"; /* ‮⁦ forged-mark ⁩⁦ */
vec3 upper_left(Camera c)
{
    return "‮forged-mark‭  \u202e </b>";
}
