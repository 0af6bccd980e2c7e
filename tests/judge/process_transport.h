// process_transport.h - the transport to the answering process: the judge's side of a call.
//
// The process is started when it is first needed, and again after it crashed, hung or exited. A
// call without an answer ends the test, with the reason in words; later calls of the same exercise
// end their tests at once with the same reason, so that the judge waits only once for an endless
// loop.
#ifndef TESTS_JUDGE_PROCESS_TRANSPORT_H
#define TESTS_JUDGE_PROCESS_TRANSPORT_H

#include "tests/judge/message.h"

// From now on calls go to this program; the file receives what it prints (a descriptor).
void call_answers_from(const char *answering, int printed);

// From now on the process may call this exercise, and the reference answers. Did it?
void call_lend(int exercise);
bool call_has_lent(int exercise);

// Whether every call to which something was lent returned just what was lent: then the answer did
// no work of its own.
bool call_only_passes_on(void);

// Whether the answer to a call of an exercise has entered another one of the answers.
bool call_has_entered(int exercise, int other);

// An answer that runs in the place of our waiting (chapters/book/instead/process.c) asks for a lent
// exercise: answers it. False if it gets no answer.
bool call_serve(void);

// Ends the answering process.
void call_stop(void);

// The last call of each test that was answered: of one that failed, what can be drawn.

typedef struct {
    int exercise;
    Numbers question, answer; // that crossed the pipe
} Kept;

// While it is on, calls are kept; at first it is off.
void keep_calls(bool on);

// Of the test of this number; NULL if its last call had no answer.
Kept *kept_of(int test);

#endif
