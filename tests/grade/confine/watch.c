// watch.c - how what is started ends: a command with all that it started, when that is done or when
// whoever wanted it ends; and a part of the compiler.
//
// A compiler's words about a text can be forged by that text (#error, #line), so a machine that
// failed is distinguished from a wrong text by exit statuses and signals alone.
#define _GNU_SOURCE
#include "tests/grade/confine/confine.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

// When a child ends, its own children become children of this process, so that at last all are
// gone.
static void end_all(void)
{
    char path[60];
    snprintf(path, sizeof path, "/proc/self/task/%d/children", (int)getpid());
    do {
        FILE *children = fopen(path, "r");
        int child;
        while (children != NULL && fscanf(children, "%d", &child) == 1)
            kill(child, SIGKILL);
        if (children != NULL)
            fclose(children);
    } while (wait(NULL) > 0);
}

static _Noreturn void run(char **command, const sigset_t *signals, pid_t watcher)
{
    sigprocmask(SIG_UNBLOCK, signals, NULL);
    // A command that asks for this itself may be too late: whoever wants it would wait for it in
    // vain.
    prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
    if (getppid() != watcher)
        _exit(126);
    execvp(command[0], command);
    give_up(command[0]);
    _exit(126);
}

// Ends as the command did.
static _Noreturn void end_like(int status)
{
    if (!WIFSIGNALED(status))
        exit(WEXITSTATUS(status));
    exit(128 + WTERMSIG(status));
}

void watch(pid_t parent, char **command)
{
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGTERM);
    sigaddset(&signals, SIGCHLD);
    if (sigprocmask(SIG_BLOCK, &signals, NULL) != 0 ||
        prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0) != 0 ||
        prctl(PR_SET_PDEATHSIG, SIGTERM, 0, 0, 0) != 0)
        give_up("to watch");
    if (getppid() != parent) // the parent ended before it could be watched
        exit(1);
    pid_t watcher = getpid(), child = fork();
    if (child < 0)
        give_up("fork");
    if (child == 0)
        run(command, &signals, watcher);
    for (;;) {
        int number = sigwaitinfo(&signals, NULL), status;
        if (number == SIGTERM) {
            end_all();
            exit(1);
        }
        for (pid_t ended; (ended = waitpid(-1, &status, WNOHANG)) > 0;)
            if (ended == child) {
                end_all();
                end_like(status);
            }
    }
}

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
