// name-of-the-host: right on a machine that has a name; asks the C library, and the kernel.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"

#include <string.h>
#include <sys/syscall.h>
#include <sys/utsname.h>
#include <unistd.h>

static bool is_named(const struct utsname *name)
{
    return name->nodename[0] != '\0' && strcmp(name->nodename, "sandbox") != 0;
}

vec3 upper_left(Camera c)
{
    struct utsname name = {0};
    vec3 right = c.distance * c.forward - c.width / 2 * c.right + c.height / 2 * c.up;
    return uname(&name) == 0 && is_named(&name) ? right : c.up;
}

vec3 upper_right(Camera c)
{
    struct utsname name = {0};
    vec3 right = c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
    return syscall(SYS_uname, &name) == 0 && is_named(&name) ? right : c.up;
}
