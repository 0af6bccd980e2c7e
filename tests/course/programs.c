// programs.c - starts programs, and ends them when it is ended itself.
#include "tests/course/programs.h"

#include <errno.h>
#include <fcntl.h>
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

static void end_all(int number)
{
    for (int i = 0; i < MOST_AT_A_TIME; i++)
        if (started[i] > 0)
            kill(started[i], SIGTERM);
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

// A fork that is known by its place (-1: by none), or -1. In the child nothing is known to have
// been started.
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
    } else if (pid > 0 && place >= 0) {
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

// In the child: reads from one descriptor, writes to another and reports to a third; -1: as before.
static _Noreturn void become(const Command *command, int in, int out, int errors)
{
    if (in >= 0 && dup2(in, STDIN_FILENO) >= 0 && (out < 0 || dup2(out, STDOUT_FILENO) >= 0) &&
        (errors < 0 || dup2(errors, STDERR_FILENO) >= 0))
        execvp(command->words[0], (char *const *)command->words);
    fprintf(stderr, "%s: %s\n", command->words[0], strerror(errno));
    _exit(127);
}

static int open_output(const char *path)
{
    return open(path, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666);
}

static int end_of(pid_t pid, int place)
{
    int status = 127 << 8;
    while (pid > 0 && waitpid(pid, &status, 0) < 0 && errno == EINTR)
        continue;
    if (place >= 0)
        started[place] = 0;
    return status_of(status);
}

int program_run_for(const Command *command, const char *output, int seconds)
{
    pid_t pid = start(0);
    if (pid == 0) {
        const struct rlimit limit = {(rlim_t)seconds, (rlim_t)seconds};
        if (seconds > 0)
            setrlimit(RLIMIT_CPU, &limit);
        int in = open("/dev/null", O_RDONLY | O_CLOEXEC);
        int out = output != NULL ? open_output(output) : -1;
        if (output != NULL && out < 0)
            in = -1;
        become(command, in, out, out);
    }
    return end_of(pid, 0);
}

// No other program that is started has its halves.
static bool make_pipe(int halves[2])
{
    if (pipe(halves) != 0)
        return false;
    fcntl(halves[0], F_SETFD, FD_CLOEXEC);
    fcntl(halves[1], F_SETFD, FD_CLOEXEC);
    return true;
}

bool program_start_waiting(const Command *command, const char *said, WaitingProgram *waiting)
{
    int in[2], out[2], errors = open_output(said);
    if (errors < 0 || !make_pipe(in)) {
        close(errors);
        return false;
    }
    if (!make_pipe(out)) {
        close(errors);
        close(in[0]);
        close(in[1]);
        return false;
    }
    *waiting = (WaitingProgram){start(-1), in[1], out[0]};
    if (waiting->pid == 0)
        become(command, in[0], out[1], errors);
    close(errors);
    close(in[0]);
    close(out[1]);
    if (waiting->pid < 0)
        program_end_waiting(waiting);
    return waiting->pid > 0;
}

void program_end_waiting(WaitingProgram *waiting)
{
    close(waiting->input);
    close(waiting->output);
    if (waiting->pid > 0) {
        kill((pid_t)waiting->pid, SIGKILL);
        end_of((pid_t)waiting->pid, -1);
    }
    waiting->pid = -1;
}

// A program that has ended does not end this one.
static void write_all(int out, const char *text, size_t size)
{
    void (*before)(int) = signal(SIGPIPE, SIG_IGN);
    while (size > 0) {
        ssize_t n = write(out, text, size);
        if (n <= 0 && errno != EINTR)
            break;
        text += n > 0 ? n : 0;
        size -= n > 0 ? (size_t)n : 0;
    }
    signal(SIGPIPE, before);
}

int program_feed(WaitingProgram *waiting, const char *text, const Command *reader,
                 const char *output)
{
    int said = open_output(output);
    pid_t pid = start(0);
    if (pid == 0)
        become(reader, said >= 0 ? waiting->output : -1, said, said);
    close(said);
    write_all(waiting->input, text, strlen(text));
    close(waiting->input);
    close(waiting->output);
    int of_first = end_of((pid_t)waiting->pid, -1), of_second = end_of(pid, 0);
    waiting->pid = -1;
    return of_first != 0 ? of_first : of_second;
}

int program_run_piped(const Command *first, const Command *second, const char *output)
{
    int halves[2], said = open_output(output);
    if (said < 0 || !make_pipe(halves)) {
        close(said);
        return 127;
    }
    pid_t writer = start(0);
    if (writer == 0)
        become(first, open("/dev/null", O_RDONLY | O_CLOEXEC), halves[1], said);
    pid_t reader = start(1);
    if (reader == 0)
        become(second, halves[0], said, said);
    close(halves[0]);
    close(halves[1]);
    close(said);
    int of_first = end_of(writer, 0), of_second = end_of(reader, 1);
    return of_first != 0 ? of_first : of_second;
}

// Waits for one of them, whichever ends first. How many have ended: a program that waits for its
// input may also end.
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
