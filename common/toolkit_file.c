// toolkit_file.c - finds the toolkit's own files, upwards from this program.
#include "common/toolkit_file.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#ifndef PATH_MAX
#define PATH_MAX 4096
#endif

// A shell that finds a program by PATH passes its name alone.
static bool find_by_path(char real[PATH_MAX], const char *program)
{
    const char *folders = getenv("PATH");
    for (const char *rest = folders; rest != NULL && *rest != '\0';) {
        size_t length = strcspn(rest, ":");
        char path[PATH_MAX];
        int used = snprintf(path, sizeof path, "%.*s/%s", (int)length, rest, program);
        if (used < (int)sizeof path && access(path, X_OK) == 0 && realpath(path, real) != NULL)
            return true;
        rest += length + (rest[length] == ':');
    }
    return false;
}

// Linux knows the program's place; elsewhere it follows from argv[0].
static bool find_program(char real[PATH_MAX], const char *program)
{
    ssize_t used = readlink("/proc/self/exe", real, PATH_MAX - 1);
    if (used > 0) {
        real[used] = '\0';
        return true;
    }
    if (program == NULL)
        return false;
    return strchr(program, '/') != NULL ? realpath(program, real) != NULL
                                        : find_by_path(real, program);
}

// In the folder of a file, or in one above it. Cuts 'below' short.
static bool is_above(char *below, char *path, size_t size, const char *name)
{
    for (char *slash; (slash = strrchr(below, '/')) != NULL;) {
        *slash = '\0';
        if (snprintf(path, size, "%s/%s", below, name) < (int)size && access(path, R_OK) == 0)
            return true;
    }
    return false;
}

bool toolkit_file(char *path, size_t size, const char *program, const char *name)
{
    char below[PATH_MAX + 2];
    if (find_program(below, program) && is_above(below, path, size, name))
        return true;
    if (getcwd(below, PATH_MAX) != NULL && is_above(strcat(below, "/."), path, size, name))
        return true;
    fprintf(stderr,
            "%s: %s is neither above this program nor above the current folder: expected the "
            "program where make built it\n",
            program != NULL ? program : "a program", name);
    return false;
}
