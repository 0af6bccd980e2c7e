// process.c - the answering process, and its pipes.
#include "tests/judge/process.h"

#include "common/clock.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#ifdef __linux__
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif
#include <time.h>
#include <unistd.h>

enum {
    MOST_PRINTED = 1 << 20,  // bytes in one test
    MOST_MEMORY = 512 << 20, // bytes
    LOOK = 50,               // milliseconds from one look at the process to the next
    MOST_ASLEEP = 40,        // looks in a row at which it slept
    MOST_WAIT = 60,          // seconds in all, on a machine that is very busy
};

static const char *program;
static int printed_file = -1;
static pid_t pid;            // 0: none is running
static clockid_t work_clock; // of its work
static bool has_clock;
static int calls_out = -1, answers_in = -1;
static int start_errors = -1; // a pipe that is closed when the program has been started

void process_begin(const char *answering, int printed)
{
    program = answering;
    printed_file = printed;
    // After the text that is there already, also if the judge has emptied the file in between.
    fcntl(printed, F_SETFL, O_APPEND);
    signal(SIGPIPE, SIG_IGN);
#ifdef __linux__
    if (getenv("CONFINE") != NULL)
        prctl(PR_SET_PDEATHSIG, SIGKILL); // a grader that is killed leaves no process running
#endif
}

FILE *process_printed_file(void)
{
#ifdef __linux__
    int memory = (int)syscall(SYS_memfd_create, "printed", 1u); // closed by exec
    if (memory >= 0)
        return fdopen(memory, "w+");
#endif
    return tmpfile();
}

// More if every access is checked.
double process_most_work(void)
{
    static double seconds;
    if (seconds == 0) {
        const char *wanted = getenv("CALL_SECONDS");
        seconds = wanted != NULL ? strtod(wanted, NULL) : 0;
        if (!(seconds > 0))
            seconds = 1;
    }
    return seconds;
}

static void limit(int what, rlim_t most)
{
    struct rlimit limits = {most, most};
    setrlimit(what, &limits);
}

bool process_is_confined(void)
{
    return getenv("CONFINE") != NULL;
}

static void say_error(void)
{
    int error = errno;
    if (write(START_ERROR, &error, sizeof error) < 0)
        _exit(126);
    _exit(127);
}

static void become_answering(const int calls[2], const int answers[2], const int errors[2])
{
    // Through high numbers, so that none of the five is closed when another is placed.
    int in = fcntl(calls[0], F_DUPFD, 20), out = fcntl(answers[1], F_DUPFD, 20);
    int print = fcntl(printed_file, F_DUPFD, 20), said = fcntl(errors[1], F_DUPFD, 20);
    int null = open("/dev/null", O_RDONLY);
    if (in < 0 || out < 0 || print < 0 || said < 0 || dup2(said, START_ERROR) < 0 ||
        dup2(null, STDIN_FILENO) < 0 || dup2(print, STDOUT_FILENO) < 0 ||
        dup2(print, STDERR_FILENO) < 0 || dup2(in, CALLS_IN) < 0 || dup2(out, ANSWERS_OUT) < 0)
        say_error();
    for (int i = START_ERROR + 1; i < 64; i++)
        close(i);
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL); // if the judge is killed, nothing limits it any more
#endif
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, MOST_PRINTED);
#ifndef __SANITIZE_ADDRESS__ // whose shadow is larger than any limit
    limit(RLIMIT_AS, MOST_MEMORY);
#endif
    const char *confine = getenv("CONFINE"); // tests/grade/confine/, for hostile answers
    char *const environment[] = {NULL};
    if (confine != NULL) { // which closes START_ERROR when it starts the program
        execve(confine, (char *[]){"confine", "answer", (char *)program, NULL}, environment);
    } else {
        fcntl(START_ERROR, F_SETFD, FD_CLOEXEC);
        execve(program, (char *[]){"answering", NULL}, environment);
    }
    say_error();
}

bool process_start(void)
{
    if (pid != 0)
        return true;
    int calls[2], answers[2], errors[2];
    if (pipe(calls) != 0 || pipe(answers) != 0 || pipe(errors) != 0)
        return false;
    fflush(NULL);
    pid = fork();
    if (pid == 0)
        become_answering(calls, answers, errors);
    int error = errno;
    close(calls[0]);
    close(answers[1]);
    close(errors[1]);
    if (start_errors >= 0)
        close(start_errors);
    calls_out = calls[1];
    answers_in = answers[0];
    start_errors = errors[0];
    errno = error;
    fcntl(calls_out, F_SETFL, O_NONBLOCK);
    fcntl(answers_in, F_SETFL, O_NONBLOCK);
    if (pid < 0)
        pid = 0;
    has_clock = pid > 0 && clock_getcpuclockid(pid, &work_clock) == 0;
    return pid > 0;
}

int process_start_error(void)
{
    int error;
    return read(start_errors, &error, sizeof error) == sizeof error ? error : 0;
}

int process_stop(bool wait_for_it)
{
    int status = -1;
    if (pid == 0)
        return status;
    close(calls_out);
    close(answers_in);
    double until = clock_seconds() + (wait_for_it ? 1 : 0);
    pid_t ended = 0;
    while ((ended = waitpid(pid, &status, WNOHANG)) == 0 && clock_seconds() < until)
        poll(NULL, 0, 1);
    if (ended != pid) {
        kill(pid, SIGKILL);
        waitpid(pid, NULL, 0);
        status = -1;
    }
    pid = 0;
    return status;
}

double process_work(void)
{
    struct timespec time;
    if (!has_clock || clock_gettime(work_clock, &time) != 0)
        return 0;
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

Patience patience_begin(void)
{
    double work = process_work();
    return (Patience){.work_before = work, .work = work, .since = clock_seconds()};
}

// Not merely waiting for a processor, nor stopped. True if that cannot be read.
static bool is_asleep(void)
{
    char path[40], words[600];
    snprintf(path, sizeof path, "/proc/%d/stat", (int)pid);
    FILE *file = fopen(path, "r");
    if (file == NULL)
        return true;
    size_t size = fread(words, 1, sizeof words - 1, file);
    fclose(file);
    words[size] = '\0';
    const char *name_end = strrchr(words, ')');
    return name_end == NULL || strncmp(name_end, ") S", 3) == 0;
}

static bool look(Patience *patience, bool may_sleep)
{
    double work = process_work();
    bool sleeps = !may_sleep && work <= patience->work + 1e-4 && is_asleep();
    patience->looks_asleep = sleeps ? patience->looks_asleep + 1 : 0;
    patience->work = work;
    patience->end = work - patience->work_before > process_most_work() ? TOO_MUCH_WORK
                    : patience->looks_asleep > MOST_ASLEEP             ? WAITS_IN_VAIN
                    : clock_seconds() - patience->since > MOST_WAIT    ? MACHINE_TOO_BUSY
                                                                       : PATIENT;
    return patience->end != PATIENT;
}

bool patience_is_over(Patience *patience)
{
    return look(patience, true);
}

static int move(bool out, void *bytes, size_t size, Patience *left)
{
    char *place = bytes;
    for (;;) {
        ssize_t n = out ? write(calls_out, place, size) : read(answers_in, place, size);
        if (n == (ssize_t)size)
            return 1;
        if (n == 0 || (n < 0 && errno != EAGAIN && errno != EINTR))
            return -1;
        struct pollfd end = {out ? calls_out : answers_in, out ? POLLOUT : POLLIN, 0};
        bool ready = poll(&end, 1, LOOK) > 0;
        if (n > 0) {
            place += n;
            size -= (size_t)n;
        }
        // Bytes that arrive one by one are not an answer either. Once there are some, it may sleep.
        if ((!ready || place != bytes) && look(left, ready))
            return 0;
    }
}

int process_send(const void *bytes, size_t size, Patience *patience)
{
    return move(true, (void *)bytes, size, patience);
}

int process_receive(void *bytes, size_t size, Patience *patience)
{
    return move(false, bytes, size, patience);
}

// ---- what a forbidden system call was for ------------------------------------------------------

// Those that an answer makes through the C library, knowingly or not.
static const struct {
    int number;
    const char *purpose;
} system_calls[] = {
    {SYS_openat, "to open a file"},
    {SYS_socket, "the network"},
    {SYS_socketpair, "to start another program"},
    {SYS_pipe2, "to start another program"},
    {SYS_execve, "to start another program"},
    {SYS_clone, "to start a process or a thread"},
#ifdef SYS_clone3
    {SYS_clone3, "to start a process or a thread"},
#endif
#ifdef SYS_open
    {SYS_open, "to open a file"},
    {SYS_fork, "to start a process or a thread"},
    {SYS_vfork, "to start a process or a thread"},
    {SYS_pipe, "to start another program"},
    {SYS_time, "the time"},
#endif
    {SYS_kill, "to send a signal"},
    {SYS_tkill, "to send a signal"},
    {SYS_tgkill, "to send a signal"},
    {SYS_nanosleep, "to sleep"},
    {SYS_clock_nanosleep, "to sleep"},
    {SYS_clock_gettime, "the time"},
    {SYS_getrandom, "random numbers"},
    {SYS_mmap, "code that is made while it runs, or a file"},
    {SYS_mprotect, "code that is made while it runs"},
};

const char *system_call_purpose(int number)
{
    for (size_t i = 0; i < sizeof system_calls / sizeof system_calls[0]; i++)
        if (system_calls[i].number == number)
            return system_calls[i].purpose;
    return "something of the operating system";
}
