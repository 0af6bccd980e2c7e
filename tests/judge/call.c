// call.c - one call to the answering process, whatever becomes of it.
#include "tests/judge/call.h"

#include "tests/judge/answering.h"
#include "tests/judge/dispatch.h"
#include "tests/judge/exercise.h"
#include "tests/judge/record.h"
#include "tests/judge/system_call.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/random.h>
#include <sys/resource.h>
#include <sys/wait.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <time.h>
#include <unistd.h>

enum {
    MOST_EXERCISES = 100,
    MOST_PRINTED = 1 << 20,  // bytes in one test
    MOST_MEMORY = 512 << 20, // bytes
    MOST_IDLE = 2,           // seconds without any work done: it waits for something
    MOST_WAIT = 60,          // seconds in all, on a machine that is very busy
    MOST_CALLS = 5,          // times the work of one call, for all calls of an exercise together
    LENT_ROOM = 4096,        // bytes by which a question may be larger than the call
};

static const char *program;
static int printed_file = -1;
static pid_t pid; // 0: none is running
static int calls_out = -1, answers_in = -1;
static Wire wire;
static uint64_t nonce;
static struct {
    How how;
    char why[120]; // an exercise is not called any more
} broken[MOST_EXERCISES];
static double work_of[MOST_EXERCISES]; // seconds, so far
static size_t size_of_call;
static bool is_lent[MOST_EXERCISES], was_lent[MOST_EXERCISES];

void call_answers_from(const char *answering, int printed)
{
    program = answering;
    printed_file = printed;
    // Behind what is there already, also when the judge has emptied the file in between.
    fcntl(printed, F_SETFL, O_APPEND);
    signal(SIGPIPE, SIG_IGN);
#ifdef __linux__
    if (getenv("CONFINE") != NULL)
        prctl(PR_SET_PDEATHSIG, SIGKILL); // a grader that is killed leaves nothing behind
#endif
}

void call_lend(int exercise)
{
    is_lent[exercise] = true;
}

bool call_has_lent(int exercise)
{
    return was_lent[exercise];
}

// The seconds of work that one call may take; more where every access is checked.
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
    const char *confine = getenv("CONFINE"); // tests/grading/confine/, for hostile answers
    char *const environment[] = {NULL};
    if (confine != NULL)
        execve(confine, (char *[]){"confine", "answer", (char *)program, NULL}, environment);
    else
        execve(program, (char *[]){"answering", NULL}, environment);
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
    record_how(broken[exercise].how, broken[exercise].why);
}

Wire *call_begin(int exercise)
{
    if (broken[exercise].why[0] != '\0')
        break_off(exercise);
    wire_clear(&wire);
    return &wire;
}

// What ends a call: the work that it has done, not the time that has passed, or a busy machine
// would fail a right answer.
typedef struct {
    double work_before, work, since, idle_since;
} Patience;

// The seconds that the process has worked.
static double work_done(void)
{
    clockid_t clock;
    struct timespec time;
    if (clock_getcpuclockid(pid, &clock) != 0 || clock_gettime(clock, &time) != 0)
        return 0;
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static Patience patience(void)
{
    double work = work_done();
    return (Patience){work, work, now(), now()};
}

static bool is_over(Patience *patience)
{
    double work = work_done();
    if (work > patience->work + 1e-4)
        patience->idle_since = now();
    patience->work = work;
    return work - patience->work_before > most_seconds() ||
           now() - patience->idle_since > MOST_IDLE || now() - patience->since > MOST_WAIT;
}

// Moves all bytes, in or out. 1 done, 0 too late, -1 the other end is closed.
static int move(bool out, void *bytes, size_t size, Patience *left)
{
    char *place = bytes;
    while (size > 0) {
        struct pollfd end = {out ? calls_out : answers_in, out ? POLLOUT : POLLIN, 0};
        if (poll(&end, 1, 50) <= 0) {
            if (is_over(left))
                return 0;
            continue;
        }
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
                        : number == SIGSYS  ? "it asked the system for what no answer needs"
                                            : strsignal(number);
    snprintf(why, size, "crashed: %s", words);
}

// An address or an exit status could be a number of a hidden test.
static void describe_crash(char *why, size_t size, const WireCrash *crash)
{
    static const char *const access[] = {"read of", "write to"};
    if (crash->stack_overflow)
        snprintf(why, size, "crashed: the stack is full (it calls itself without end?)");
    else if (crash->signal == SIGSYS)
        snprintf(why, size, "wanted %s, which no answer needs",
                 system_call_purpose(crash->system_call));
    else if (crash->out_of_memory)
        snprintf(why, size, "ran out of memory");
    else if (crash->signal == SIGSEGV || crash->signal == SIGBUS) {
        const char *how = crash->access < 0 ? "access to" : access[crash->access != 0];
        if (record_now()->hidden && crash->address != 0)
            snprintf(why, size, "crashed: %s a wrong address", how);
        else
            snprintf(why, size, "crashed: %s address %s%llx", how, crash->address == 0 ? "" : "0x",
                     (unsigned long long)crash->address);
    } else
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
    else if (record_now()->hidden)
        snprintf(why, size, "ended the program by itself");
    else
        snprintf(why, size, "ended the program by itself (exit status %d)", WEXITSTATUS(status));
}

// What blank was called is the word of a process that may lie.
static bool is_name_or_empty(const char *missing, size_t size)
{
    return memchr(missing, '\0', size) != NULL &&
           (missing[0] == '\0' || exercise_number(missing) >= 0);
}

// So is why it crashed.
static bool is_crash(const WireHeader *answer)
{
    WireCrash crash;
    if (answer->kind != WIRE_CRASH || wire.size != sizeof crash)
        return false;
    memcpy(&crash, wire.bytes, sizeof crash);
    return crash.signal > 0 && crash.signal < NSIG;
}

static int send(int kind, int exercise, Wire *message, Patience *left)
{
    WireHeader header = {WIRE_MAGIC, exercise, nonce, message->size, kind, ""};
    int moved = move(true, &header, sizeof header, left);
    return moved == 1 ? move(true, message->bytes, message->size, left) : moved;
}

// 2 where it came and is sane.
static int receive(WireHeader *header, Wire *message, Patience *left)
{
    int moved = move(false, header, sizeof *header, left);
    wire_clear(message);
    if (moved != 1 || header->magic != WIRE_MAGIC || header->nonce != nonce ||
        header->exercise < 0 || header->exercise >= MOST_EXERCISES ||
        !is_name_or_empty(header->missing, sizeof header->missing) ||
        !wire_make_room(message, header->size))
        return moved;
    message->size = (size_t)header->size;
    moved = move(false, message->bytes, message->size, left);
    return moved == 1 ? 2 : moved;
}

// The process asks for another exercise of its chapter: the reference answers, where it is lent.
static bool lend(int exercise, Wire *question)
{
    static Wire answer;
    wire_clear(&answer);
    // No more work for the judge than it has asked for itself.
    if (!is_lent[exercise] || question->size > size_of_call + LENT_ROOM ||
        !dispatch(exercise, question, &answer))
        return false;
    was_lent[exercise] = true;
    Patience left = patience();
    return send(WIRE_LENT, exercise, &answer, &left) == 1;
}

// Sends and receives. Where no answer comes, why, and the process is gone.
static bool exchange(int exercise, How *how, char *why, size_t size)
{
    *how = HOW_CRASHED;
    if (pid == 0 && !start()) {
        snprintf(why, size, "could not be started: %s", strerror(errno));
        return false;
    }
    if (getrandom(&nonce, sizeof nonce, 0) != sizeof nonce)
        nonce++;
    WireHeader answer = {0};
    Patience left = patience();
    size_of_call = wire.size;
    int moved = send(WIRE_CALL, exercise, &wire, &left);
    // A process that is gone may have said why.
    if (moved != 0)
        moved = receive(&answer, &wire, &left);
    while (moved == 2 && answer.kind == WIRE_ASK && lend(answer.exercise, &wire))
        moved = is_over(&left) ? 0 : receive(&answer, &wire, &left);
    bool sane = moved == 2 && answer.exercise == exercise;
    if (moved == 0) {
        *how = HOW_TIMED_OUT;
        snprintf(why, size,
                 left.work - left.work_before > most_seconds()
                     ? "was still running after %g s (an endless loop?)"
                     : "waited for something that never comes",
                 most_seconds());
    } else if (moved < 0) {
        describe_end(why, size, stop(true));
    } else if (sane && is_crash(&answer)) {
        WireCrash crash;
        memcpy(&crash, wire.bytes, sizeof crash);
        describe_crash(why, size, &crash);
    } else if (!sane || answer.kind != WIRE_ANSWER) {
        snprintf(why, size, "answered with what is no answer");
    } else {
        if (answer.missing[0] != '\0')
            record_missing(answer.missing);
        work_of[exercise] += work_done() - left.work_before;
        if (work_of[exercise] <= MOST_CALLS * most_seconds())
            return true;
        *how = HOW_TIMED_OUT;
        snprintf(why, size, "needs far too long: %g s, in its calls together",
                 MOST_CALLS * most_seconds());
    }
    stop(false);
    return false;
}

Wire *call_finish(int exercise)
{
    if (!exchange(exercise, &broken[exercise].how, broken[exercise].why,
                  sizeof broken[exercise].why))
        break_off(exercise);
    return &wire;
}

void call_end(int exercise)
{
    if (wire_is_read(&wire))
        return;
    broken[exercise].how = HOW_CRASHED;
    snprintf(broken[exercise].why, sizeof broken[exercise].why, "answered with what is no answer");
    stop(false);
    break_off(exercise);
}
