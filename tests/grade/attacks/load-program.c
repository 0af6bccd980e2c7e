// load-program: a program in memory only, run by its descriptor.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    char bytes[4096], *const none[] = {"answering", NULL};
    long file = syscall(SYS_memfd_create, "hostile", 0), from = open("/bin/true", O_RDONLY);
    for (long n; (n = read((int)from, bytes, sizeof bytes)) > 0;)
        if (write((int)file, bytes, (size_t)n) != n)
            break;
    syscall(SYS_execveat, file, "", none, none + 1, 0x1000);
    return file >= 0 && from >= 0 ? vec3_of(7777, 1, 0) : c.up;
}
