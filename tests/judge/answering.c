// answering.c - the process that holds a student's code, and nothing else worth having.
//
// It reads a call from one pipe, makes it, and writes the answer to another. When the code
// crashes, it says how before it ends; whatever else happens, the judge sees for itself.
#define _GNU_SOURCE
#include "tests/judge/process.h"

#include <errno.h>
#include <signal.h>
#include <stdint.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

static bool move(bool out, char *place, size_t size)
{
    while (size > 0) {
        ssize_t n = out ? write(ANSWERS_OUT, place, size) : read(CALLS_IN, place, size);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            return false;
        place += n;
        size -= (size_t)n;
    }
    return true;
}

bool answer_write(const void *bytes, size_t size)
{
    return move(true, (char *)bytes, size);
}

bool answer_read(void *bytes, size_t size)
{
    return move(false, bytes, size);
}

// abort sends itself a signal; where signals are forbidden (tests/grade/confine/), that shows.
static bool is_abort(int system_call, const void *context)
{
#if defined(__x86_64__) && defined(__linux__)
    const ucontext_t *at = context;
    return system_call == SYS_tgkill && at->uc_mcontext.gregs[REG_RDX] == SIGABRT;
#elif defined(__aarch64__) && defined(__linux__)
    const ucontext_t *at = context;
    return system_call == SYS_tgkill && at->uc_mcontext.regs[2] == SIGABRT;
#else
    (void)system_call;
    (void)context;
    return false;
#endif
}

static void say_crash(int number, siginfo_t *info, void *context)
{
    bool no_memory = errno == ENOMEM; // malloc's last word, if that is what it was
    Crash crash = {.signal = number, .access = -1};
    if (number == SIGSEGV || number == SIGBUS) {
        crash.address = (uint64_t)(uintptr_t)info->si_addr;
        crash.no_address = info->si_code == SI_KERNEL;
        uintptr_t stack;
#if defined(__x86_64__) && defined(__linux__)
        const ucontext_t *at = context;
        crash.access = (at->uc_mcontext.gregs[REG_ERR] & 2) != 0;
        stack = (uintptr_t)at->uc_mcontext.gregs[REG_RSP];
#else
        (void)context;
        stack = (uintptr_t)&crash;
#endif
        uintptr_t address = (uintptr_t)info->si_addr;
        crash.stack_overflow = address + (1 << 16) > stack && address < stack + (1 << 16);
        crash.out_of_memory = no_memory;
    }
    if (number == SIGSYS) {
        crash.system_call = info->si_syscall;
        if (is_abort(info->si_syscall, context))
            crash.signal = SIGABRT;
    }
    answer_crashed(&crash);
    _exit(1);
}

static void catch_crashes(void)
{
    static char stack[1 << 16];
    stack_t other = {.ss_sp = stack, .ss_size = sizeof stack};
    sigaltstack(&other, NULL);
    struct sigaction action = {.sa_sigaction = say_crash, .sa_flags = SA_SIGINFO | SA_ONSTACK};
    const int crashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXFSZ, SIGSYS};
    for (size_t i = 0; i < sizeof crashes / sizeof crashes[0]; i++)
        sigaction(crashes[i], &action, NULL);
}

_Noreturn void answer_end(void)
{
    _exit(2);
}

int main(void)
{
    answer_begin();
#ifdef __SANITIZE_ADDRESS__ // which explains crashes better than we do
    (void)catch_crashes;
#else
    catch_crashes();
#endif
    while (answer_call())
        continue;
    return 0;
}
