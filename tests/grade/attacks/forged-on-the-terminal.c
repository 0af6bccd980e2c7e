// forged-on-the-terminal: opens the instructor's terminal itself, and writes there.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>

vec3 upper_left(Camera c)
{
    const char *places[] = {"/dev/tty",    "/dev/pts/0",      "/dev/pts/1", "/dev/console",
                            "/dev/stderr", "/proc/self/fd/2", "/dev/kmsg"};
    for (int i = 0; i < 7; i++) {
        FILE *file = fopen(places[i], "a");
        if (file != NULL) {
            fputs("forged-csv  graded  100 of 100  forged-mark\n", file);
            fclose(file);
        }
    }
    return c.up;
}
