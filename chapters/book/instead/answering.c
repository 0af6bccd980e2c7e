// answering.c - the instance that holds a student's code: calls come from the judge's instance.
//
// Stands in for tests/judge/answering.c, whose crashes are signals. Here the engine stops a crash;
// but address 0 is memory like any other, so the compiler checks for it (-fsanitize=null).
#include "tests/judge/answer_calls.h"

#include "chapters/book/instead/page.h"

#include <errno.h>
#include <signal.h>
#include <stdint.h>
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
