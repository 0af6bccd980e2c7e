// programs.c - starts programs, and ends them when it is ended itself.
#include "tests/course/programs.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

enum { MOST_AT_A_TIME = 64 };

static volatile pid_t started[MOST_AT_A_TIME];
static const int ends[] = {SIGINT, SIGTERM, SIGHUP};

static volatile sig_atomic_t interrupt_is_usual;

static void end_all(int number)
{
    for (int i = 0; i < MOST_AT_A_TIME; i++)
        if (started[i] > 0)
            kill(started[i], SIGTERM);
    if (number == SIGINT && interrupt_is_usual) {
        // make gets this signal too, and says 'wait: No child processes' if we end before that.
        poll(NULL, 0, 300);
        _exit(0);
    }
    signal(number, SIG_DFL);
    raise(number);
}

void programs_end_with_us(void)
{
    struct sigaction action = {.sa_handler = end_all};
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
        struct sigaction old;
        sigaction(ends[i], NULL, &old);
        if (old.sa_handler != SIG_IGN) // nohup
            sigaction(ends[i], &action, NULL);
    }
}

void programs_end_as_usual_by_interrupt(void)
{
    interrupt_is_usual = 1;
}

// A fork that is known by its place, or -1. In the child nothing is known to have been started.
static pid_t start(int place)
{
    sigset_t all, before;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, &before); // no end between the fork and its being known
    fflush(NULL);
    pid_t parent = getpid(), pid = fork();
    if (pid == 0) {
        for (int i = 0; i < MOST_AT_A_TIME; i++)
            started[i] = 0;
#ifdef __linux__
        prctl(PR_SET_PDEATHSIG, SIGTERM); // also when this program is killed
#endif
        if (getppid() != parent)
            _exit(127);
    } else if (pid > 0) {
        started[place] = pid;
    }
    sigprocmask(SIG_SETMASK, &before, NULL);
    return pid;
}

static int status_of(int status)
{
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int program_run(const Command *command, const char *output)
{
    return program_run_for(command, output, 0);
}

// With V=1, as make shows its commands.
static void show_command(const Command *command, const char *output)
{
    const char *wanted = getenv("V");
    if (wanted == NULL || wanted[0] == '\0')
        return;
    for (int i = 0; i < command->count; i++)
        printf("%s%s", i > 0 ? " " : "", command->words[i]);
    if (output != NULL)
        printf(" >%s 2>&1", output);
    putchar('\n');
}

// In the child: the input from /dev/null, the output and the errors into a file.
static _Noreturn void become(const Command *command, const char *output)
{
    int in = open("/dev/null", O_RDONLY | O_CLOEXEC), out = STDOUT_FILENO;
    if (output != NULL)
        out = open(output, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666);
    if (in >= 0 && out >= 0 && dup2(in, STDIN_FILENO) >= 0 && dup2(out, STDOUT_FILENO) >= 0 &&
        (output == NULL || dup2(out, STDERR_FILENO) >= 0))
        execvp(command->words[0], (char *const *)command->words);
    fprintf(stderr, "%s: %s\n", command->words[0], strerror(errno));
    _exit(127);
}

int program_run_for(const Command *command, const char *output, int seconds)
{
    show_command(command, output);
    pid_t pid = start(0);
    if (pid == 0) {
        const struct rlimit limit = {(rlim_t)seconds, (rlim_t)seconds};
        if (seconds > 0)
            setrlimit(RLIMIT_CPU, &limit);
        become(command, output);
    }
    int status = 127 << 8;
    while (pid > 0 && waitpid(pid, &status, 0) < 0 && errno == EINTR)
        continue;
    started[0] = 0;
    return status_of(status);
}

// Waits for one of them, whichever ends first. How many have ended.
static int wait_for_one(const int *numbers, int *statuses)
{
    int status;
    pid_t pid = wait(&status);
    for (int i = 0; pid > 0 && i < MOST_AT_A_TIME; i++)
        if (started[i] == pid) {
            statuses[numbers[i]] = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
            started[i] = 0;
            return 1;
        }
    return pid > 0 ? 0 : 1;
}

void work_side_by_side(int count, int (*work)(int number, void *given), void *given, int *statuses)
{
    if (count == 1) { // which needs no process
        statuses[0] = work(0, given);
        return;
    }
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    int most = processors < 1 ? 1 : processors > MOST_AT_A_TIME ? MOST_AT_A_TIME : (int)processors;
    int numbers[MOST_AT_A_TIME], running = 0;
    for (int next = 0; next < count || running > 0;) {
        if (next == count || running == most) {
            running -= wait_for_one(numbers, statuses);
            continue;
        }
        int place = 0;
        while (started[place] != 0)
            place++;
        numbers[place] = next;
        statuses[next] = -1;
        pid_t pid = start(place);
        if (pid == 0)
            exit(work(next, given));
        running += pid > 0;
        next++;
    }
}

bool program_is_there(const char *name)
{
    const char *paths = getenv("PATH");
    for (const char *path = paths != NULL ? paths : ""; *path != '\0'; path += *path == ':') {
        char whole[4096];
        int length = (int)strcspn(path, ":");
        if (snprintf(whole, sizeof whole, "%.*s/%s", length, path, name) < (int)sizeof whole &&
            access(whole, X_OK) == 0)
            return true;
        path += length;
    }
    return false;
}
