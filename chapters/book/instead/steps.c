// steps.c - counts the steps of a student's code, so that an endless loop ends.
//
// The compiler calls this at the begin of each block of code (-fsanitize-coverage=trace-pc). A step
// is the same on every machine; a second is not.
#include "chapters/book/instead/page.h"

#include <stdint.h>

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

void __sanitizer_cov_trace_pc(void);
void __sanitizer_cov_trace_pc(void)
{
    if (++count > most)
        out_of_steps();
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
