// lends_nothing.c - for the judge of a handout, which has no reference to lend (call.h).
#include "tests/judge/dispatch.h"

bool dispatch(int exercise, Wire *in, Wire *out)
{
    (void)exercise, (void)in, (void)out;
    return false;
}
