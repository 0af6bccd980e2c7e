// steps.c - at each step of a student's code: they are counted, so that an endless loop ends, and
// the stack below is filled, so that a variable that was never set does not look right.
//
// The compiler calls this at the begin of each block of code (-fsanitize-coverage=trace-pc). A step
// is the same on every machine; a second is not.
#include "chapters/book/instead/page.h"
#include "tests/judge/message.h"

#include <stdint.h>
#include <string.h>

static double count, most = 1e300;

__attribute__((export_name("allow_steps"))) void allow_steps(double steps);
void allow_steps(double steps)
{
    most = count + steps;
}

__attribute__((export_name("steps_so_far"))) double steps_so_far(void);
double steps_so_far(void)
{
    return count;
}

static bool fills; // not for a program that draws
static int byte;
static uintptr_t filled_below;

__attribute__((noinline)) static void fill(void)
{
    unsigned char room[4096];
    memset(room, byte, sizeof room);
    __asm__ volatile("" : : "r"(room) : "memory"); // or nobody would need to fill it
}

void fill_stack_with(int with)
{
    fills = true;
    byte = with;
    fill();
}

void fill_stack_again(void)
{
    if (fills)
        fill();
}

// What a function finds in its frame was filled by the one that calls it; it fills the frames of
// those that it calls. A function that was called before in the same block may have left something
// there: the block would have to end first.
void __sanitizer_cov_trace_pc(void);
void __sanitizer_cov_trace_pc(void)
{
    uintptr_t below = (uintptr_t)__builtin_frame_address(0);
    if (++count > most)
        out_of_steps();
    if (fills && below != filled_below)
        fill();
    filled_below = below;
}

// Where nobody explains a crash (answering.c), the program just ends.
void __ubsan_handle_type_mismatch_v1_abort(const void *data, uintptr_t pointer)
    __attribute__((weak));
void __ubsan_handle_type_mismatch_v1_abort(const void *data, uintptr_t pointer)
{
    (void)data;
    (void)pointer;
    __builtin_trap();
}
