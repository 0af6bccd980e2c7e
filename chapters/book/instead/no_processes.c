// no_processes.c - system calls about processes, terminals and locks, for programs that live
// without.
#include "chapters/book/instead/include/no_processes.h"

#include <sys/file.h>
#include <unistd.h>

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
