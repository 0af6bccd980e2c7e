// transport.h - how a call reaches its answer, and how the results come back.
//
// The tests call exercises by their contract names; the main program chooses what answers: a
// process over a pipe (process_transport.h), a table of recorded answers (table.h), a function of
// this process (tests/handout/direct_transport.h), or anything else that has these functions.
#ifndef TESTS_JUDGE_TRANSPORT_H
#define TESTS_JUDGE_TRANSPORT_H

#include "tests/judge/wire.h"

typedef struct {
    Wire *(*begin)(int exercise);   // an empty message, for the arguments
    void (*send)(int exercise);     // they are all in it
    Wire *(*receive)(int exercise); // waits for the results
    void (*finish)(int exercise);   // all of them were read; may be NULL
} Transport;

// From now on calls go this way.
void transport_use(const Transport *transport);

// One call: put the arguments into the message that begins it, read the results from the answer.
Wire *transport_begin(int exercise);
Wire *transport_answer(int exercise);
void transport_finish(int exercise);

// The same with the values of a call (message.h).
void transport_call(int exercise, void *result, void *const *arguments);

#endif
