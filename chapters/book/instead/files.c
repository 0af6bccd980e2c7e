// files.c - files, for programs in a page: the toolkit's own are at the top, and nobody else reads
// those that are written.
//
// Stands in for common/toolkit_file.c, which looks above the program, and for common/whole_file.c,
// which needs signals and permissions.
#include "common/toolkit_file.h"
#include "common/whole_file.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

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
