// answering.c - the instance that holds a student's code: calls come from the judge's instance, and
// say which exercises an answer enters. Some of these are lent.
//
// Stands in for tests/judge/answering.c, whose crashes are signals, and for calls_traced.c. Here
// the engine stops a crash; but address 0 is memory like any other, so the compiler checks for it
// (-fsanitize=null). The linker puts __wrap_NAME in the place of all calls of an exercise, in the
// student's file too (--wrap=NAME): there the call is reported, and goes to the answer, or to the
// judge if the exercise is lent. So nothing is linked again to lend it.
// ANSWERED: the chapter. EARLIER_ANSWERS: it is linked with the student's answers to the chapters
// before it (a handout), so calls of those are reported too.
#include "tests/judge/message.h"

#include "chapters/book/instead/page.h"
#include "tests/judge/exercise.h"
#include "tests/judge/parameters.h"

#include <errno.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

bool answer_read(void *bytes, size_t size)
{
    return call_get(bytes, size);
}

bool answer_write(const void *bytes, size_t size)
{
    call_put(bytes, size);
    return true;
}

_Noreturn void answer_end(void)
{
    _exit(2);
}

__attribute__((export_name("answer"))) bool answer(void);
bool answer(void)
{
    static bool has_begun;
    if (!has_begun)
        answer_begin();
    has_begun = true;
    return answer_call();
}

static _Noreturn void crash(Crash crash)
{
    answer_crashed(&crash);
    _exit(1);
}

// The C library's would only trap, like the end of an array.
_Noreturn void abort(void)
{
    crash((Crash){.signal = SIGABRT, .access = -1});
}

// ---- what the compiler calls if a check of it fails ---------------------------------------------

// How memory was used, as clang numbers it: 0 a load, 1 a store, 3 and 4 a part of a struct.
typedef struct {
    const char *file;
    uint32_t line, column;
    const void *type;
    uint8_t log_alignment, how;
} TypeMismatch;

void __ubsan_handle_type_mismatch_v1_abort(const TypeMismatch *data, uintptr_t pointer);
void __ubsan_handle_type_mismatch_v1_abort(const TypeMismatch *data, uintptr_t pointer)
{
    int access = data->how == 0 ? 0 : data->how == 1 ? 1 : -1;
    bool no_memory = errno == ENOMEM; // malloc's last word, if that is what it was
    crash((Crash){
        .signal = SIGSEGV, .access = access, .address = pointer, .out_of_memory = no_memory});
}

// ---- which exercises an answer enters, and which of them are lent ------------------------------

static bool is_known[EXERCISE_COUNT];
static int called = -1;
static void (*say)(int other);

void trace_calls_of(int exercise, void (*entered)(int other))
{
    if (exercise != called)
        memset(is_known, 0, sizeof is_known);
    called = exercise;
    say = entered;
}

void trace_end(void)
{
    say = NULL;
}

static void enter(int exercise)
{
    fill_stack_again();
    if (say == NULL || is_known[exercise] || exercise == called)
        return;
    is_known[exercise] = true;
    say(exercise);
}

// The environment names those that are lent.
static bool is_lent(int exercise)
{
    static bool lent[EXERCISE_COUNT], is_read;
    const char *names = getenv("LENT");
    for (; !is_read && names != NULL && *names != '\0'; names += strspn(names, " ")) {
        char name[64];
        int length = (int)strcspn(names, " ");
        snprintf(name, sizeof name, "%.*s", length, names);
        if (exercise_number(name) >= 0)
            lent[exercise_number(name)] = true;
        names += length;
    }
    is_read = true;
    return lent[exercise];
}

#include "tests/exercises.def" // the contracts

// A handout lends nothing, and has no lent_NAME.
#define WRAP(result, name, parameters)                                                             \
    result lent_##name(DECLARED(parameters)) __attribute__((weak));                                \
    result __real_##name(DECLARED(parameters));                                                    \
    result __wrap_##name(DECLARED(parameters));                                                    \
    result __wrap_##name(DECLARED(parameters))                                                     \
    {                                                                                              \
        enter(NUMBER_##name);                                                                      \
        IF_VOID(result, , return )                                                                 \
        is_lent(NUMBER_##name) ? lent_##name(NAMES(parameters))                                    \
                               : __real_##name(NAMES(parameters));                                 \
    }

#ifdef EARLIER_ANSWERS
#define CHAPTER(number) (ANSWERED >= number)
#else
#define CHAPTER(number) (ANSWERED == 0 || ANSWERED == number)
#endif
#define EXERCISE(stem, result, name, parameters, ...) WRAP(result, name, parameters)
#include "tests/exercises.def"
