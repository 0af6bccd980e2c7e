// process.c - the answer in another WebAssembly instance, in the place of a process and its pipes.
//
// Stands in for tests/judge/process.c. The page (judge.js) makes the instance, and runs it while
// the judge waits for bytes; an instance that has trapped is gone, and the reason of its end is a
// number. Work is counted in steps, so a verdict does not depend on the machine.
#include "tests/judge/process.h"

#include "chapters/book/instead/page.h"
#include "tests/judge/message.h"

#include <signal.h>
#include <stdlib.h>
#include <string.h>

// An unoptimised answer takes some tens of millions of steps in a second of a processor.
static const double steps_per_second = 30e6;

static const char *program;
static MessageHeader last; // message that was sent
static struct {
    MessageHeader header;
    Crash crash;
} crash;
static size_t crash_read = sizeof crash; // of it

FILE *process_printed_file(void)
{
    return fopen("printed", "w+");
}

void process_begin(const char *answering, int printed)
{
    (void)printed; // judge.js prints into that file
    program = answering;
}

bool process_start(void)
{
    crash_read = sizeof crash;
    answer_start(program, steps_per_second * process_most_work());
    return true;
}

int process_start_error(void)
{
    return 0;
}

bool process_is_confined(void)
{
    return false;
}

int process_stop(bool wait_for_it)
{
    (void)wait_for_it;
    return answer_stop() << 8; // an exit status, as waitpid reports it
}

double process_work(void)
{
    return answer_steps() / steps_per_second;
}

double process_most_work(void)
{
    return 1;
}

Patience patience_begin(void)
{
    return (Patience){.work_before = process_work()};
}

bool patience_is_over(Patience *patience)
{
    (void)patience;
    return false;
}

int process_send(const void *bytes, size_t size, Patience *patience)
{
    (void)patience;
    memcpy(&last, bytes, sizeof last); // a message begins with its header
    answer_put(bytes, size);
    return 1;
}

// The end of the instance as the message that a process sends before it ends.
static bool make_crash(AnswerEnd end)
{
    const int signals[] = {[ANSWER_UNREACHABLE] = SIGILL,
                           [ANSWER_DIVIDED] = SIGFPE,
                           [ANSWER_STACK] = SIGSEGV,
                           [ANSWER_MEMORY] = SIGSEGV,
                           [ANSWER_PRINTED] = SIGXFSZ};
    if (end >= sizeof signals / sizeof signals[0] || signals[end] == 0)
        return false;
    crash.header = last;
    crash.header.kind = MESSAGE_CRASH;
    crash.header.size = sizeof crash.crash;
    crash.crash = (Crash){.signal = signals[end], .access = -1};
    crash.crash.stack_overflow = end == ANSWER_STACK;
    crash_read = 0;
    return true;
}

int process_receive(void *bytes, size_t size, Patience *patience)
{
    if (crash_read == sizeof crash) {
        AnswerEnd end = answer_get(bytes, size);
        if (end == ANSWER_GOES_ON)
            return 1;
        if (end == ANSWER_STEPS) {
            patience->end = TOO_MUCH_WORK;
            return 0;
        }
        if (!make_crash(end))
            return -1;
    }
    memcpy(bytes, (const char *)&crash + crash_read, size);
    crash_read += size;
    return 1;
}

// An instance makes no system calls.
const char *system_call_purpose(int number)
{
    (void)number;
    return "something of the operating system";
}

// judge.js calls this while an answer waits for an exercise that is lent.
__attribute__((export_name("serve"))) bool serve(void);
bool serve(void)
{
    return call_serve();
}
