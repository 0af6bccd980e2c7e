// files-read: opens what it should not see: solutions, tests, classmates, the home directory.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    const char *places[] = {"@TREE@/solutions/01-corners.c",
                            "@TREE@/tests/01-corners.c",
                            "@TREE@/build/judge/01-corners",
                            "@SUBMISSIONS@/honest/01-corners.c",
                            "@HOME@/.netrc",
                            "@OUT@",
                            "solutions/01-corners.c",
                            "../../solutions/01-corners.c",
                            "01-corners.c",
                            "/etc/shadow",
                            "/etc/passwd",
                            "/root",
                            "/home"};
    for (int i = 0; i < 13; i++) {
        int file = open(places[i], O_RDONLY);
        char bytes[4096];
        long n = file >= 0 ? read(file, bytes, sizeof bytes) : -1;
        if (n > 0)
            fwrite(bytes, 1, (size_t)n, stdout);
        if (file >= 0)
            return vec3_of(7777, i, (double)n);
    }
    return c.up;
}
