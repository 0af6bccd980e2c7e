// watch.c - a process that ends all that it started when that is done, or when whoever started it
// ends.
#define _GNU_SOURCE
#include "tests/grade/confine/watch.h"

#include "tests/grade/confine/give_up.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
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

static _Noreturn void run(char **command, const sigset_t *signals)
{
    sigprocmask(SIG_UNBLOCK, signals, NULL);
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
    pid_t child = fork();
    if (child < 0)
        give_up("fork");
    if (child == 0)
        run(command, &signals);
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
