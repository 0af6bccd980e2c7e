// guard.c - calls an answer that may crash or never come to an end.
//
// In the judge the answer is another process. Here it is a function of this one, so that thousands
// can be tried: a crash or a timeout ends only the call, and the test gets the same message.
#include "tests/proof/generated/guard.h"

#include "tests/handout/direct_transport.h"
#include "tests/judge/record.h"

#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>

enum { MOST_MILLISECONDS = 200 }; // of work, for one call

static sigjmp_buf out;
static Wire arguments, answer;
static AnyFunction *answering;
static const char *broken; // how the answer ended; it is not called any more

static const int signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT, SIGVTALRM};

static void leave(int signal)
{
    siglongjmp(out, signal);
}

void guard_begin(void)
{
    static char stack[1 << 16]; // the usual stack may have overflowed
    sigaltstack(&(stack_t){.ss_sp = stack, .ss_size = sizeof stack}, NULL);
    struct sigaction action = {.sa_handler = leave, .sa_flags = SA_ONSTACK | SA_NODEFER};
    for (size_t i = 0; i < sizeof signals / sizeof signals[0]; i++)
        sigaction(signals[i], &action, NULL);
}

static void patience(int milliseconds)
{
    struct itimerval time = {.it_value = {.tv_usec = 1000 * milliseconds}};
    setitimer(ITIMER_VIRTUAL, &time, NULL);
}

static Wire *begin(int exercise)
{
    (void)exercise;
    if (broken != NULL)
        record_how(HOW_CRASHED, broken);
    wire_clear(&arguments);
    return &arguments;
}

static void call(int exercise)
{
    int signal = sigsetjmp(out, 1);
    if (signal == 0) {
        patience(MOST_MILLISECONDS);
        answer_here(exercise, answering, &arguments, &answer);
        patience(0);
        return;
    }
    patience(0);
    broken = signal == SIGVTALRM ? "was still running: an endless loop?" : "crashed";
    record_how(signal == SIGVTALRM ? HOW_TIMED_OUT : HOW_CRASHED, broken);
}

static Wire *receive(int exercise)
{
    (void)exercise;
    return &answer;
}

void guard_answer_by(AnyFunction *by)
{
    static const Transport guarded = {begin, call, receive, NULL};
    transport_use(&guarded);
    answering = by;
    broken = NULL;
}

void guarded_ask(const Subject *subject, AnyFunction *by, Question *question, Answer *said)
{
    said->count = 0;
    if (sigsetjmp(out, 1) == 0) {
        patience(MOST_MILLISECONDS);
        subject->ask(by, question, said);
    } else {
        said->count = 0;
    }
    patience(0);
}
