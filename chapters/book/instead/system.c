// system.c - what the system gives to programs, which a page has not, or does in another way.
#include "chapters/book/instead/system.h"

#include "common/toolkit_file.h"
#include "common/whole_file.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
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

int madvise(void *memory, size_t size, int how)
{
    (void)memory;
    (void)size;
    (void)how;
    return -1;
}

ssize_t getrandom(void *bytes, size_t size, unsigned flags)
{
    (void)flags;
    return getentropy(bytes, size) == 0 ? (ssize_t)size : -1;
}

// ---- files: the toolkit's own are at the top, and nobody else reads those that are written -----

// In the place of common/toolkit_file.c, which looks above the program, and common/whole_file.c,
// which needs signals and permissions.
bool toolkit_file(char *path, size_t size, const char *program, const char *name)
{
    (void)program;
    return snprintf(path, size, "%s", name) < (int)size && access(path, R_OK) == 0;
}

bool file_path_is_writable(const char *path, Message *message)
{
    (void)path;
    (void)message;
    return true;
}

bool file_is_same(const char *one, const char *other)
{
    struct stat a, b;
    return stat(one, &a) == 0 && stat(other, &b) == 0 && a.st_ino == b.st_ino;
}

bool file_write_whole(const char *path, FileWriter *write, const void *given, Message *message)
{
    FILE *file = fopen(path, "wb");
    if (file == NULL)
        return message_set(message, "%s: cannot be written: %s", path, strerror(errno));
    bool done = write(file, given, path, message);
    return fclose(file) == 0 && done;
}

// ---- rounded correctly, so that a verdict in the page has the same last digit ------------------

// WebAssembly's C library rounds it another way for 13 in 100 of the angles below 90 degrees. In
// the terminal it depends on the C library: glibc 2.36 rounds 4 in 100 another way.
float tanf(float angle)
{
    return (float)tan((double)angle);
}
