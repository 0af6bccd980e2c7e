// call.c - one call to the answering process, whatever becomes of it.
#include "tests/judge/call.h"

#include "tests/judge/answering.h"
#include "tests/judge/record.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/random.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum {
    MOST_EXERCISES = 100,
    MOST_PRINTED = 1 << 20,  // bytes in one test
    MOST_MEMORY = 512 << 20, // bytes
};

static const char *program;
static int printed_file = -1;
static pid_t pid; // 0: none is running
static int calls_out = -1, answers_in = -1;
static Wire wire;
static uint64_t nonce;
static char broken[MOST_EXERCISES][120]; // why an exercise is not called any more

void call_answers_from(const char *answering, int printed)
{
    program = answering;
    printed_file = printed;
    // Behind what is there already, also when the judge has emptied the file in between.
    fcntl(printed, F_SETFL, O_APPEND);
    signal(SIGPIPE, SIG_IGN);
}

// The seconds that one call may take; more where the machine is slow or checks every access.
static double most_seconds(void)
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

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static void limit(int what, rlim_t most)
{
    struct rlimit limits = {most, most};
    setrlimit(what, &limits);
}

static void become_answering(const int calls[2], const int answers[2])
{
    // Through high numbers, so that none of the four is closed by placing another.
    int in = fcntl(calls[0], F_DUPFD, 20), out = fcntl(answers[1], F_DUPFD, 20);
    int print = fcntl(printed_file, F_DUPFD, 20);
    int null = open("/dev/null", O_RDONLY);
    if (in < 0 || out < 0 || print < 0 || dup2(null, STDIN_FILENO) < 0 ||
        dup2(print, STDOUT_FILENO) < 0 || dup2(print, STDERR_FILENO) < 0 ||
        dup2(in, CALLS_IN) < 0 || dup2(out, ANSWERS_OUT) < 0)
        _exit(126);
    for (int i = ANSWERS_OUT + 1; i < 64; i++)
        close(i);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, MOST_PRINTED);
#ifndef __SANITIZE_ADDRESS__ // whose shadow is larger than any limit
    limit(RLIMIT_AS, MOST_MEMORY);
#endif
    char *const arguments[] = {(char *)"answering", NULL};
    char *const environment[] = {NULL};
    execve(program, arguments, environment);
    _exit(127);
}

static bool start(void)
{
    int calls[2], answers[2];
    if (pipe(calls) != 0 || pipe(answers) != 0)
        return false;
    fflush(NULL);
    pid = fork();
    if (pid == 0)
        become_answering(calls, answers);
    close(calls[0]);
    close(answers[1]);
    calls_out = calls[1];
    answers_in = answers[0];
    fcntl(calls_out, F_SETFL, O_NONBLOCK);
    fcntl(answers_in, F_SETFL, O_NONBLOCK);
    if (pid < 0)
        pid = 0;
    return pid > 0;
}

// Ends the process. Its exit status where it ended by itself, within a moment; else -1.
static int stop(bool wait_for_it)
{
    int status = -1;
    if (pid == 0)
        return status;
    close(calls_out);
    close(answers_in);
    double until = now() + (wait_for_it ? 0.2 : 0);
    pid_t ended = 0;
    while ((ended = waitpid(pid, &status, WNOHANG)) == 0 && now() < until)
        poll(NULL, 0, 1);
    if (ended != pid) {
        kill(pid, SIGKILL);
        waitpid(pid, NULL, 0);
        status = -1;
    }
    pid = 0;
    return status;
}

void call_stop(void)
{
    stop(false);
}

static void break_off(int exercise)
{
    record_how(broken[exercise]);
}

Wire *call_begin(int exercise)
{
    if (broken[exercise][0] != '\0')
        break_off(exercise);
    wire_clear(&wire);
    return &wire;
}

// Moves all bytes, in or out, before the deadline. 1 done, 0 too late, -1 the other end is closed.
static int move(bool out, void *bytes, size_t size, double deadline)
{
    char *place = bytes;
    while (size > 0) {
        double left = deadline - now();
        if (left <= 0)
            return 0;
        struct pollfd end = {out ? calls_out : answers_in, out ? POLLOUT : POLLIN, 0};
        if (poll(&end, 1, (int)(1000 * left) + 1) <= 0)
            continue;
        ssize_t n = out ? write(calls_out, place, size) : read(answers_in, place, size);
        if (n == 0 || (n < 0 && errno != EAGAIN && errno != EINTR))
            return -1;
        if (n > 0) {
            place += n;
            size -= (size_t)n;
        }
    }
    return 1;
}

static void describe_signal(char *why, size_t size, int number)
{
    if (number == SIGXFSZ) {
        snprintf(why, size, "printed more than a million characters");
        return;
    }
    const char *words = number == SIGFPE    ? "it divided a whole number by zero"
                        : number == SIGABRT ? "it was aborted (an assertion that failed?)"
                        : number == SIGILL  ? "it went beyond the end of an array"
                        : number == SIGKILL ? "it was killed"
                                            : strsignal(number);
    snprintf(why, size, "crashed: %s", words);
}

static void describe_crash(char *why, size_t size, const WireCrash *crash)
{
    static const char *const access[] = {"read of", "write to"};
    if (crash->stack_overflow)
        snprintf(why, size, "crashed: the stack is full (it calls itself without end?)");
    else if (crash->out_of_memory)
        snprintf(why, size, "ran out of memory");
    else if (crash->signal == SIGSEGV || crash->signal == SIGBUS)
        snprintf(why, size, "crashed: %s address %s%llx",
                 crash->access < 0 ? "access to" : access[crash->access != 0],
                 crash->address == 0 ? "" : "0x", (unsigned long long)crash->address);
    else
        describe_signal(why, size, crash->signal);
}

static void describe_end(char *why, size_t size, int status)
{
    if (status < 0)
        snprintf(why, size, "closed its pipe and gave no answer");
    else if (WIFSIGNALED(status))
        describe_signal(why, size, WTERMSIG(status));
    else if (WEXITSTATUS(status) == 127)
        snprintf(why, size, "could not be started: %s", program);
    else
        snprintf(why, size, "ended the program by itself (exit status %d)", WEXITSTATUS(status));
}

// Sends and receives. Where no answer comes, false, the reason in why, and the process is gone.
static bool exchange(int exercise, char *why, size_t size)
{
    if (pid == 0 && !start()) {
        snprintf(why, size, "could not be started: %s", strerror(errno));
        return false;
    }
    if (getrandom(&nonce, sizeof nonce, 0) != sizeof nonce)
        nonce++;
    WireHeader call = {WIRE_MAGIC, exercise, nonce, wire.size, WIRE_CALL, ""};
    WireHeader answer = {0};
    double deadline = now() + most_seconds();
    int moved = move(true, &call, sizeof call, deadline);
    if (moved == 1)
        moved = move(true, wire.bytes, wire.size, deadline);
    // A process that is gone may have said why.
    if (moved != 0)
        moved = move(false, &answer, sizeof answer, deadline);
    bool sane = moved == 1 && answer.magic == WIRE_MAGIC && answer.nonce == nonce &&
                answer.exercise == exercise && answer.size <= WIRE_MOST_BYTES &&
                memchr(answer.missing, '\0', sizeof answer.missing) != NULL;
    wire_clear(&wire);
    if (sane) {
        static const uint8_t nothing[4096];
        for (uint64_t left = answer.size; left > 0; left -= left < 4096 ? left : 4096)
            wire_put(&wire, nothing, left < 4096 ? (size_t)left : 4096);
        moved = move(false, wire.bytes, (size_t)answer.size, deadline);
    }
    if (moved == 0)
        snprintf(why, size, "was still running after %g s (an endless loop?)", most_seconds());
    else if (moved < 0)
        describe_end(why, size, stop(true));
    else if (sane && answer.kind == WIRE_CRASH && answer.size == sizeof(WireCrash)) {
        WireCrash crash;
        memcpy(&crash, wire.bytes, sizeof crash);
        describe_crash(why, size, &crash);
    } else if (!sane || answer.kind != WIRE_ANSWER) {
        snprintf(why, size, "answered with what is no answer");
    } else {
        if (answer.missing[0] != '\0')
            record_missing(answer.missing);
        return true;
    }
    stop(false);
    return false;
}

Wire *call_finish(int exercise)
{
    if (!exchange(exercise, broken[exercise], sizeof broken[exercise]))
        break_off(exercise);
    return &wire;
}

void call_end(int exercise)
{
    if (wire_is_read(&wire))
        return;
    snprintf(broken[exercise], sizeof broken[exercise], "answered with what is no answer");
    stop(false);
    break_off(exercise);
}
