// tool.c - how a part of the compiler ended, and whether processes can be started at all.
//
// A compiler's words about a text can be forged by that text (#error, #line), so a machine that
// failed is distinguished from a wrong text by exit statuses and signals alone.
#include "tests/grade/confine/tool.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static int status_of_signal(int number)
{
    switch (number) {
    case SIGXCPU:
        return TOOL_WORK;
    case SIGXFSZ:
        return TOOL_FILE;
    case SIGSEGV:
    case SIGABRT:
    case SIGILL:
    case SIGFPE:
        return TOOL_CRASHED;
    default:
        return TOOL_ENDED;
    }
}

int run_tool(char **command)
{
    pid_t child = fork();
    if (child == 0) {
        execvp(command[0], command);
        fprintf(stderr, "confine: %s: %s\n", command[0], strerror(errno));
        kill(getpid(), SIGKILL); // no exit status of a tool could be mistaken for this
    }
    int status;
    if (child < 0 || waitpid(child, &status, 0) != child)
        return TOOL_ENDED;
    if (WIFSIGNALED(status))
        return status_of_signal(WTERMSIG(status));
    return WEXITSTATUS(status) == 0 ? 0 : WEXITSTATUS(status) == 1 ? TOOL_REFUSES : TOOL_ODD;
}

int room_for(int processes)
{
    int ends[2] = {-1, -1}, started = 0;
    if (pipe(ends) == 0)
        while (started < processes) {
            pid_t child = fork();
            if (child < 0)
                break;
            if (child == 0) {
                char byte;
                close(ends[1]);
                _exit(read(ends[0], &byte, 1) < 0);
            }
            started++;
        }
    if (started < processes)
        fprintf(stderr, "only %d of %d processes can be started: %s\n", started, processes,
                strerror(errno));
    close(ends[1]); // ends them all
    while (wait(NULL) > 0)
        ;
    return started < processes;
}
