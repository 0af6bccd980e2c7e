// c_library.c - what WebAssembly's C library lacks, or does in another way.
#include "chapters/book/instead/c_library.h"

#include <math.h>
#include <sys/file.h>
#include <unistd.h>

// ---- processes and locks: there are none -------------------------------------------------------

pid_t getppid(void)
{
    return 1;
}

int kill(pid_t process, int number)
{
    (void)process;
    (void)number;
    return -1;
}

int execvp(const char *file, char *const words[])
{
    (void)file;
    (void)words;
    return -1;
}

int flock(int file, int how)
{
    (void)file;
    (void)how;
    return 0;
}

ssize_t getrandom(void *bytes, size_t size, unsigned flags)
{
    (void)flags;
    return getentropy(bytes, size) == 0 ? (ssize_t)size : -1;
}

// ---- rounded correctly, so that a verdict in the page has the same last digit ------------------

// WebAssembly's C library rounds it another way for 13 in 100 of the angles below 90 degrees. In
// the terminal it depends on the C library: glibc 2.36 rounds 4 in 100 another way.
float tanf(float angle)
{
    return (float)tan((double)angle);
}
