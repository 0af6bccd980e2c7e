// answering.c - the process that holds a student's code, and nothing else worth having.
//
// It reads a call from one pipe, makes it, and writes the answer to another. When the code
// crashes, it says how before it ends; whatever else happens, the judge sees for itself.
#define _GNU_SOURCE
#include "tests/judge/answering.h"
#include "common/answers.h"
#include "tests/judge/calls_traced.h"
#include "tests/judge/dispatch.h"
#include "tests/judge/message.h"
#include "tests/judge/transport.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

static WireHeader current; // the call that is being answered

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

static bool send(const WireHeader *header, Wire *message)
{
    size_t size;
    const void *block = wire_block(message, header, &size);
    return block != NULL && write_all(block, size);
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
    WireCrash crash = {.signal = number, .access = -1};
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
        crash.out_of_memory = no_memory;
    }
    if (number == SIGSYS) {
        crash.system_call = info->si_syscall;
        if (is_abort(info->si_syscall, context))
            crash.signal = SIGABRT;
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
    const int crashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXFSZ, SIGSYS};
    for (size_t i = 0; i < sizeof crashes / sizeof crashes[0]; i++)
        sigaction(crashes[i], &action, NULL);
}

// Reads a message into the wire. False if there is none.
static bool receive(WireHeader *header, Wire *wire)
{
    wire_clear(wire);
    if (!read_all(header, sizeof *header) || header->magic != WIRE_MAGIC ||
        !wire_make_room(wire, header->size))
        return false;
    wire->size = (size_t)header->size;
    return read_all(wire->bytes, wire->size);
}

// If an exercise of this chapter is lent, its calls come here (lent_answers.c) and the judge
// answers them: this process never holds the reference of the chapter that is judged.
static Wire lent;

static Wire *begin_asking(int exercise)
{
    (void)exercise;
    wire_clear(&lent);
    return &lent;
}

static void ask_judge(int exercise)
{
    WireHeader ask = {WIRE_MAGIC, exercise, current.nonce, lent.size, WIRE_ASK, 0, 0, ""};
    if (!send(&ask, &lent))
        _exit(2);
}

static Wire *receive_lent(int exercise)
{
    WireHeader answer;
    (void)exercise;
    if (!receive(&answer, &lent) || answer.kind != WIRE_LENT)
        _exit(2);
    return &lent;
}

static void say_entered(int exercise)
{
    WireHeader header = {WIRE_MAGIC, exercise, current.nonce, 0, WIRE_ENTERED, 0, 0, ""};
    if (!write_all(&header, sizeof header))
        _exit(2);
}

// A result that the answer does not set keeps these bytes (stack_paint.h).
static __attribute__((noinline)) void paint_stack(void)
{
    enum { ROOM = 1 << 13 };
    char room[ROOM];
    if (current.paint == 0)
        return;
    memset(room, current.paint, sizeof room);
    __asm__ volatile("" : : "r"(room) : "memory"); // or nobody would need to fill it
}

int main(void)
{
    static Wire in, out;
    static const Transport judge = {begin_asking, ask_judge, receive_lent, NULL};
    transport_use(&judge);
    setvbuf(stdout, NULL, _IONBF, 0); // so that the text printed before a crash is not lost
    before_call = paint_stack;
#ifdef __SANITIZE_ADDRESS__ // which explains crashes better than we do
    (void)catch_crashes;
#else
    catch_crashes();
#endif
    while (receive(&current, &in)) {
        wire_clear(&out);
        errno = 0;
        trace_calls_of(current.exercise, say_entered);
        if (!dispatch(current.exercise, &in, &out))
            return 2;
        trace_end();
        fflush(NULL); // the printed text is there before the answer
        WireHeader header = current;
        header.kind = WIRE_ANSWER;
        header.size = out.size;
        header.overran = out.overran;
        if (answers_missing() > 0)
            snprintf(header.missing, sizeof header.missing, "%s", answer_missing(0));
        answers_forget();
        if (!send(&header, &out))
            return 2;
    }
    return 0;
}
