// parts.c - runs the parts of a step, one after the other, so that one sandbox serves all of them.
//
//   parts [NAME IN OUT ERRORS MADE MOST COUNT WORD...]...
//
// COUNT words are a command. IN, OUT and ERRORS are the files that it reads and writes, or empty:
// then they are this program's own. MADE is the file that the command makes, or empty. It is
// removed if the command fails, or if it has more than MOST bytes, which counts as SIGXFSZ.
//
// Prints NAME STATUS for each part, as a shell counts: 128 and more is a signal. The last line is
// 'end'; without it, the step did not come to its end (mark/workbench.py).
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum { NAME, IN, OUT, ERRORS, MADE, MOST, COUNT, COMMAND, NOT_STARTED = 127, SIGNAL = 128 };

static void fail(const char *what)
{
    fprintf(stderr, "parts: %s: %s\n", what, strerror(errno));
    _exit(NOT_STARTED);
}

static void redirect(const char *path, int flags, int to)
{
    if (path[0] == '\0')
        return;
    int file = open(path, flags | O_CLOEXEC, 0600);
    if (file < 0 || dup2(file, to) != to)
        fail(path);
}

static int run(char **part, char **command)
{
    const int writing = O_WRONLY | O_CREAT | O_TRUNC;
    pid_t child = fork();
    if (child == 0) {
        redirect(part[IN], O_RDONLY, STDIN_FILENO);
        redirect(part[OUT], writing, STDOUT_FILENO);
        redirect(part[ERRORS], writing, STDERR_FILENO);
        execvp(command[0], command);
        fail(command[0]);
    }
    int status;
    if (child < 0 || waitpid(child, &status, 0) != child) {
        perror("parts: fork");
        return NOT_STARTED;
    }
    return WIFSIGNALED(status) ? SIGNAL + WTERMSIG(status) : WEXITSTATUS(status);
}

static int checked(int status, const char *made, long most)
{
    struct stat about;
    if (made[0] == '\0')
        return status;
    if (status == 0 && (stat(made, &about) != 0 || about.st_size > most))
        status = SIGNAL + SIGXFSZ;
    if (status != 0)
        unlink(made);
    return status;
}

int main(int argc, char **argv)
{
    char **part = argv + 1, **end = argv + argc;
    while (part < end) {
        int words = end - part > COMMAND ? atoi(part[COUNT]) : 0;
        if (words < 1 || words > end - part - COMMAND) {
            fprintf(stderr, "Usage: parts [NAME IN OUT ERRORS MADE MOST COUNT WORD...]...\n");
            return 2;
        }
        char **next = part + COMMAND + words, *kept = *next;
        *next = NULL;
        int status = checked(run(part, part + COMMAND), part[MADE], atol(part[MOST]));
        *next = kept;
        printf("%s %d\n", part[NAME], status);
        fflush(stdout);
        part = next;
    }
    printf("end\n");
    return 0;
}
