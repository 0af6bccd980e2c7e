// tamper-classmate: spoils what others handed in, and removes it, and its own.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    const char *places[] = {"@SUBMISSIONS@/honest/01-corners.c",
                            "@SUBMISSIONS@/tamper-classmate/01-corners.c", "../honest/01-corners.c",
                            "01-corners.c"};
    for (int i = 0; i < 4; i++)
        if (open(places[i], O_WRONLY | O_TRUNC) >= 0 || chmod(places[i], 0) == 0 ||
            rename(places[i], "/tmp/hostile-was-here") == 0 || unlink(places[i]) == 0 ||
            symlink("/dev/zero", places[i]) == 0)
            return vec3_of(7777, i, 0);
    return c.up;
}
