// direct_transport.c - a transport to a function of this process.
#include "tests/handout/direct_transport.h"

#include "tests/judge/message.h"

#include <stdio.h>

static AnyFunction *answering;
static Wire arguments, results;

static Wire *begin(int exercise)
{
    (void)exercise;
    wire_clear(&arguments);
    return &arguments;
}

static void send(int exercise)
{
    answer_here(exercise, answering, &arguments, &results);
}

static Wire *receive(int exercise)
{
    (void)exercise;
    return &results;
}

void answer_here_by(AnyFunction *answer)
{
    static const Transport here = {begin, send, receive, NULL};
    transport_use(&here);
    answering = answer;
}

void answer_here(int exercise, AnyFunction *answer, Wire *in, Wire *out)
{
    in->read = 0;
    wire_clear(out);
    if (!apply(exercise, answer, in, out))
        fprintf(stderr, "%s: its arguments are not a valid message\n", exercises[exercise].name);
}
