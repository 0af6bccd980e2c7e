// calls_traced.c - what happens when a function of an answer is entered.
#include "tests/judge/message.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

// The exercises by number, and NULL for those that this program does not have. Only their addresses
// are used.
typedef void Function(void);
#define EXERCISE(stem, result, name, ...) extern __typeof__(name) name __attribute__((weak));
#include "tests/exercises.def"
#define EXERCISE(stem, result, name, ...) (Function *)name,
static Function *const exercises_here[] = {
#include "tests/exercises.def"
};

// Most functions that are entered are helpers, or are entered repeatedly: functions that need no
// further report in this call are recognised by their address.
enum { KNOWN = 256 };

static const void *known[KNOWN];
static int called = -1;
static void (*say)(int other);

void __cyg_profile_func_enter(void *function, void *from);
void __cyg_profile_func_exit(void *function, void *from);

void trace_calls_of(int exercise, void (*entered)(int other))
{
    if (exercise != called)
        memset(known, 0, sizeof known);
    called = exercise;
    say = entered;
}

void trace_end(void)
{
    say = NULL;
}

// ---- the stack ----------------------------------------------------------------------------------

enum { STACK_FILLED = 4096 }; // bytes; also in __fentry__

// What it is filled with, once a byte has been asked for. A chapter's program never asks: it draws
// a chapter that is right, in which no value is undefined, and would take eight times as long.
unsigned char stack_filling[16] __attribute__((aligned(16), visibility("hidden")));
bool stack_is_filled __attribute__((visibility("hidden")));

static __attribute__((noinline)) void fill_below(void)
{
    unsigned char room[STACK_FILLED];
    memset(room, stack_filling[0], sizeof room);
    __asm__ volatile("" : : "r"(room) : "memory"); // or nobody would need to fill it
}

void fill_stack_with(int byte)
{
    stack_is_filled = true;
    memset(stack_filling, byte, sizeof stack_filling);
    fill_below();
}

// With -pg -mfentry each function of an answer calls __fentry__ before anything else: nothing is in
// its frame yet, and all registers of its arguments have to stay as they are. On other machines the
// frame is there already when a function reports: then the frames of those that it calls are
// filled, when it is entered and when one of them returns.
#ifdef __x86_64__
__asm__(".text\n"
        ".globl __fentry__\n"
        ".type __fentry__, @function\n"
        "__fentry__:\n"
        "    cmpb $0, stack_is_filled(%rip)\n"
        "    je 2f\n"
        "    leaq -4096(%rsp), %r11\n"
        "    movaps stack_filling(%rip), %xmm8\n"
        "1:  movups %xmm8, (%r11)\n"
        "    movups %xmm8, 16(%r11)\n"
        "    movups %xmm8, 32(%r11)\n"
        "    movups %xmm8, 48(%r11)\n"
        "    addq $64, %r11\n"
        "    cmpq %rsp, %r11\n"
        "    jb 1b\n"
        "2:  ret\n"
        ".size __fentry__, . - __fentry__\n");
#define FILLED_BY_HOOKS false
#else
#define FILLED_BY_HOOKS true
#endif

// ---- what the compiler calls --------------------------------------------------------------------

void __cyg_profile_func_enter(void *function, void *from)
{
    (void)from;
    if (FILLED_BY_HOOKS && stack_is_filled)
        fill_below();
    const void **place = &known[((uintptr_t)function >> 4) % KNOWN];
    if (say == NULL || *place == function)
        return;
    *place = function;
    for (size_t i = 0; i < sizeof exercises_here / sizeof exercises_here[0]; i++)
        if ((uintptr_t)exercises_here[i] == (uintptr_t)function && (int)i != called)
            say((int)i);
}

void __cyg_profile_func_exit(void *function, void *from)
{
    (void)function;
    (void)from;
    if (FILLED_BY_HOOKS && stack_is_filled)
        fill_below();
}
