// crash_reason.c - why a call brought no answer, in words.
#include "tests/judge/crash_reason.h"

#include "tests/judge/record.h"
#include "tests/judge/system_call.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>

static void describe_signal(char *why, size_t size, int number)
{
    if (number == SIGXFSZ) {
        snprintf(why, size, "printed more than a million characters");
        return;
    }
    const char *words = number == SIGFPE    ? "it divided an integer by zero"
                        : number == SIGABRT ? "it was aborted (did an assertion fail?)"
                        : number == SIGILL  ? "it went beyond the end of an array"
                        : number == SIGKILL ? "it was killed"
                        : number == SIGSYS  ? "it made a system call that no answer needs"
                                            : strsignal(number);
    snprintf(why, size, "crashed: %s", words);
}

// An address or an exit status could be a number of a hidden test.
void describe_crash(char *why, size_t size, const WireCrash *crash)
{
    static const char *const access[] = {"read of", "write to"};
    if (crash->stack_overflow)
        snprintf(why, size, "crashed: stack overflow (does it call itself without end?)");
    else if (crash->signal == SIGSYS)
        snprintf(why, size, "wanted %s, which no answer needs",
                 system_call_purpose(crash->system_call));
    else if (crash->out_of_memory)
        snprintf(why, size, "ran out of memory");
    else if (crash->signal == SIGSEGV || crash->signal == SIGBUS) {
        const char *how = crash->access < 0 ? "access to" : access[crash->access != 0];
        if (record_now()->hidden && crash->address != 0)
            snprintf(why, size, "crashed: %s an invalid address", how);
        else
            snprintf(why, size, "crashed: %s address %s%llx", how, crash->address == 0 ? "" : "0x",
                     (unsigned long long)crash->address);
    } else
        describe_signal(why, size, crash->signal);
}

void describe_end(char *why, size_t size, int status)
{
    if (status < 0)
        snprintf(why, size, "closed its pipe and gave no answer");
    else if (WIFSIGNALED(status))
        describe_signal(why, size, WTERMSIG(status));
    else if (WEXITSTATUS(status) == 127)
        snprintf(why, size, "could not be started");
    else if (record_now()->hidden)
        snprintf(why, size, "ended the program by itself");
    else
        snprintf(why, size, "ended the program by itself (exit status %d)", WEXITSTATUS(status));
}
