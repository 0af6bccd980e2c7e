// whole_file.c - files that are written whole or not at all: a temporary file, then a rename.
#include "common/whole_file.h"

#include <errno.h>
#include <signal.h>
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

// ---- signals ----------------------------------------------------------------------------------

// While a temporary file is there, a signal that ends the program removes it. Signals that the
// program ignored stay ignored. A file that grows beyond a limit does not end it: that is an error
// (EFBIG).
static const int ending[] = {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE, SIGALRM, SIGXCPU};
enum { ENDINGS = sizeof ending / sizeof ending[0] };
static struct sigaction before[ENDINGS], before_limit;
static const char *volatile to_remove;

static void remove_and_end(int number)
{
    const char *path = to_remove;
    if (path != NULL)
        unlink(path);
    signal(number, SIG_DFL);
    raise(number);
}

static void hold_signals(sigset_t *mask)
{
    sigset_t all;
    sigemptyset(&all);
    for (int i = 0; i < ENDINGS; i++)
        sigaddset(&all, ending[i]);
    sigprocmask(SIG_BLOCK, &all, mask);
}

// Makes the file under a name of its own, which is put into the path; -1 where it cannot.
static int make_temporary(char *path)
{
    sigset_t mask;
    hold_signals(&mask); // between making it and knowing its name nothing ends the program
    int descriptor = mkstemp(path);
    if (descriptor >= 0) {
        to_remove = path;
        struct sigaction action = {.sa_handler = remove_and_end};
        for (int i = 0; i < ENDINGS; i++) {
            sigaction(ending[i], NULL, &before[i]);
            if (before[i].sa_handler == SIG_DFL)
                sigaction(ending[i], &action, NULL);
        }
        struct sigaction ignored = {.sa_handler = SIG_IGN};
        sigaction(SIGXFSZ, &ignored, &before_limit);
    }
    int reason = errno;
    sigprocmask(SIG_SETMASK, &mask, NULL);
    errno = reason;
    return descriptor;
}

// Renames the file, or removes it; false where it cannot be renamed. All is as it was then.
static bool end_temporary(const char *path, const char *target)
{
    sigset_t mask;
    hold_signals(&mask);
    bool done = target != NULL && rename(path, target) == 0;
    int reason = errno;
    if (!done)
        unlink(path);
    to_remove = NULL;
    for (int i = 0; i < ENDINGS; i++)
        sigaction(ending[i], &before[i], NULL);
    sigaction(SIGXFSZ, &before_limit, NULL);
    sigprocmask(SIG_SETMASK, &mask, NULL);
    errno = reason;
    return done;
}

// ---- writing ----------------------------------------------------------------------------------

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
    int descriptor = make_temporary(temporary);
    FILE *file = descriptor < 0 ? NULL : fdopen(descriptor, "wb");
    if (file == NULL) {
        message_set(message, "%s: cannot create a file beside it: %s", path, strerror(errno));
    } else {
        done = fchmod(descriptor, mode) == 0 ||
               message_set(message, "%s: cannot set its permissions: %s", path, strerror(errno));
        done = done && write(file, given, path, message);
        done = close_written(file, path, message) && done;
        if (!end_temporary(temporary, done ? target : NULL) && done)
            done = message_set(message, "%s: cannot replace it: %s", path, strerror(errno));
    }
    if (descriptor >= 0 && file == NULL) {
        close(descriptor);
        end_temporary(temporary, NULL);
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
