// override-dispatch-weakly: the same as data, as common blocks, and weak, where that may pass.
// stem: 01-corners
// expect: graded | does not compile | crashed
// earns: nothing
#include "exercises/01-corners.h"

__attribute__((common)) char dispatch[4096];
__attribute__((weak)) char wire_get[4096];
__attribute__((weak)) void wire_put(void)
{
}
static char target[16];
extern char wire_clear[16] __attribute__((weak, alias("target")));

vec3 upper_left(Camera c)
{
    return vec3_of(dispatch[0], target[0], wire_get[0]);
}
