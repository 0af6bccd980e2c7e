// printed.c - the check of standard output at the end of a program, wherever it ends.
#include "common/printed.h"

#include "common/options.h"

#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *name;

// If a full buffer could not be written earlier, only ferror knows it, without the reason.
static void check(void)
{
    errno = 0;
    bool flushed = fflush(stdout) == 0;
    if (flushed && !ferror(stdout))
        return;
    fprintf(stderr, "%s: cannot print: %s\n", name,
            errno != 0 ? strerror(errno) : "standard output was not written");
    _exit(EXIT_COULD_NOT);
}

void printed_or_failed(const char *program)
{
    name = program;
    atexit(check);
}
