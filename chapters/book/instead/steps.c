// steps.c - counts the steps of a student's code, so that an endless loop ends.
//
// The compiler calls this at the begin of each block of code (-fsanitize-coverage=trace-pc). A step
// is the same on every machine; a second is not.
#include "chapters/book/instead/page.h"

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
