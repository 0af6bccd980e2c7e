// here.c - a call that a known function answers, in this process.
#include "tests/told/here.h"

#include "tests/judge/dispatch.h"
#include "tests/judge/record.h"

#include <stdio.h>
#include <string.h>

// Dispatching calls the exercise by its name, which asks the switchboard. No test is about it then,
// so that nobody is suspected on the way.
void answer_here(int exercise, AnyFunction *answer, Wire *in, Wire *out)
{
    char function[sizeof record_now()->function];
    memcpy(function, record_now()->function, sizeof function);
    record_now()->function[0] = '\0';
    switch_one(exercises[exercise].name, answer);
    in->read = 0;
    wire_clear(out);
    if (!dispatch(exercise, in, out))
        fprintf(stderr, "%s: its arguments are no message\n", exercises[exercise].name);
    switch_one(exercises[exercise].name, NULL);
    memcpy(record_now()->function, function, sizeof function);
}
