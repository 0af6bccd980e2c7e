// answering.c - the process that holds a student's code, and nothing else worth having.
//
// It reads a call from one pipe, makes it, and writes the answer to another. When the code
// crashes, it says how before it ends; whatever else happens, the judge sees for itself.
#define _GNU_SOURCE
#include "tests/judge/answering.h"
#include "common/answers.h"
#include "tests/judge/dispatch.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <ucontext.h>
#include <unistd.h>

static WireHeader current; // the call that is being answered
static volatile sig_atomic_t allocation_failed;

// Allocations of the student's go through here (the linker's --wrap), so that a crash on a NULL
// that malloc returned can be called by its name.
void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *old, size_t size);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *old, size_t size);

static void *noted(void *memory)
{
    if (memory == NULL)
        allocation_failed = 1;
    return memory;
}

void *__wrap_malloc(size_t size)
{
    return noted(__real_malloc(size));
}

void *__wrap_calloc(size_t count, size_t size)
{
    return noted(__real_calloc(count, size));
}

void *__wrap_realloc(void *old, size_t size)
{
    return noted(__real_realloc(old, size));
}

static bool write_all(const void *bytes, size_t size)
{
    const char *from = bytes;
    while (size > 0) {
        ssize_t n = write(ANSWERS_OUT, from, size);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            return false;
        from += n;
        size -= (size_t)n;
    }
    return true;
}

static bool read_all(void *bytes, size_t size)
{
    char *into = bytes;
    while (size > 0) {
        ssize_t n = read(CALLS_IN, into, size);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            return false;
        into += n;
        size -= (size_t)n;
    }
    return true;
}

static void say_crash(int number, siginfo_t *info, void *context)
{
    WireCrash crash = {.signal = number, .access = -1, .out_of_memory = allocation_failed};
    if (number == SIGSEGV || number == SIGBUS) {
        crash.address = (uint64_t)(uintptr_t)info->si_addr;
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
    }
    WireHeader header = current;
    header.kind = WIRE_CRASH;
    header.size = sizeof crash;
    write_all(&header, sizeof header);
    write_all(&crash, sizeof crash);
    _exit(1);
}

static void catch_crashes(void)
{
    static char stack[1 << 16];
    stack_t other = {.ss_sp = stack, .ss_size = sizeof stack};
    sigaltstack(&other, NULL);
    struct sigaction action = {.sa_sigaction = say_crash, .sa_flags = SA_SIGINFO | SA_ONSTACK};
    const int crashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXFSZ};
    for (size_t i = 0; i < sizeof crashes / sizeof crashes[0]; i++)
        sigaction(crashes[i], &action, NULL);
}

int main(void)
{
    Wire in = {0}, out = {0};
#ifndef __SANITIZE_ADDRESS__ // which explains crashes better than we do
    catch_crashes();
#endif
    while (read_all(&current, sizeof current)) {
        wire_clear(&in);
        wire_clear(&out);
        if (current.magic != WIRE_MAGIC || current.size > WIRE_MOST_BYTES)
            return 2;
        if (current.size > in.room) {
            free(in.bytes);
            in.room = (size_t)current.size;
            in.bytes = malloc(in.room);
            if (in.bytes == NULL)
                return 2;
        }
        in.size = (size_t)current.size;
        if (!read_all(in.bytes, in.size) || !dispatch(current.exercise, &in, &out))
            return 2;
        fflush(NULL); // what was printed is there before the answer is
        WireHeader header = current;
        header.kind = WIRE_ANSWER;
        header.size = out.size;
        if (answers_missing() > 0)
            snprintf(header.missing, sizeof header.missing, "%s", answer_missing(0));
        answers_forget();
        if (!write_all(&header, sizeof header) || !write_all(out.bytes, out.size))
            return 2;
    }
    return 0;
}
