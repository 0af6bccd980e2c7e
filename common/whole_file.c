// whole_file.c - files that are written whole or not at all: a temporary file, then a rename.
#include "common/whole_file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bool close_written(FILE *file, const char *path, Message *message)
{
    if (fclose(file) == 0)
        return true;
    return message_set(message, "%s: cannot be written: %s", path, strerror(errno));
}

// The file a path leads to, links followed, so that a rename replaces the file and not the link.
static char *final_path(const char *path)
{
    char *real = realpath(path, NULL);
    return real != NULL ? real : strdup(path);
}

static bool replace_file(const char *path, mode_t mode, FileWriter *write, const void *given,
                         Message *message)
{
    char *target = final_path(path);
    char *temporary = target == NULL ? NULL : malloc(strlen(target) + sizeof "./.XXXXXX");
    if (temporary == NULL) {
        free(target);
        return message_set(message, "%s: out of memory", path);
    }
    char *slash = strrchr(target, '/');
    sprintf(temporary, "%.*s/.XXXXXX", slash == NULL ? 1 : (int)(slash - target),
            slash == NULL ? "." : target);

    bool done = false;
    int descriptor = mkstemp(temporary);
    FILE *file = descriptor < 0 ? NULL : fdopen(descriptor, "wb");
    if (file == NULL) {
        message_set(message, "%s: cannot create a file beside it: %s", path, strerror(errno));
    } else {
        done = fchmod(descriptor, mode) == 0 ||
               message_set(message, "%s: cannot set its permissions: %s", path, strerror(errno));
        done = done && write(file, given, path, message);
        done = close_written(file, path, message) && done;
        if (done && rename(temporary, target) != 0)
            done = message_set(message, "%s: cannot replace it: %s", path, strerror(errno));
        if (!done)
            unlink(temporary);
    }
    free(temporary);
    free(target);
    return done;
}

bool file_is_same(const char *one, const char *other)
{
    struct stat a, b;
    return stat(one, &a) == 0 && stat(other, &b) == 0 && S_ISREG(a.st_mode) &&
           a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

bool file_path_is_writable(const char *path, Message *message)
{
    struct stat status;
    if (stat(path, &status) == 0) {
        if (S_ISDIR(status.st_mode))
            return message_set(message, "%s: is a folder, expected a file name", path);
        if (access(path, W_OK) != 0)
            return message_set(message, "%s: cannot be written: %s", path, strerror(errno));
        return true;
    }
    if (errno != ENOENT)
        return message_set(message, "%s: cannot be written: %s", path, strerror(errno));
    if (lstat(path, &status) == 0)
        return message_set(message, "%s: is a link that leads nowhere", path);
    const char *slash = strrchr(path, '/');
    char *folder = slash == NULL ? strdup(".") : strndup(path, (size_t)(slash - path) + 1);
    bool writable = folder != NULL && access(folder, W_OK | X_OK) == 0;
    if (!writable)
        message_set(message, "%s: cannot write into the folder '%s': %s", path,
                    folder != NULL ? folder : "", strerror(errno));
    free(folder);
    return writable;
}

bool file_write_whole(const char *path, FileWriter *write, const void *given, Message *message)
{
    if (!file_path_is_writable(path, message))
        return false;
    struct stat status;
    bool exists = stat(path, &status) == 0;
    if (!exists || S_ISREG(status.st_mode)) {
        mode_t mask = umask(0);
        umask(mask);
        return replace_file(path, exists ? status.st_mode & 0777 : 0666 & ~mask, write, given,
                            message);
    }
    FILE *device = fopen(path, "wb");
    if (device == NULL)
        return message_set(message, "%s: cannot be opened: %s", path, strerror(errno));
    bool done = write(device, given, path, message);
    return close_written(device, path, message) && done;
}
