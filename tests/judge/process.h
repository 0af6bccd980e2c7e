// process.h - the answering process: its start and end, its pipes, and how long to wait for it
// (process.c); and the transport to it, the judge's side of a call (process_transport.c).
#ifndef TESTS_JUDGE_PROCESS_H
#define TESTS_JUDGE_PROCESS_H

#include "tests/judge/message.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

// The ends of its pipes, as it sees them. The third is closed when the program starts: until then
// an errno is written to it if that fails.
enum { CALLS_IN = 3, ANSWERS_OUT = 4, START_ERROR = 5 };

// A file for what the answers print, which takes no room on a disk if that is possible. NULL, and
// errno, if it cannot be made.
FILE *process_printed_file(void);

// The program to start, through confine if the environment has CONFINE; and the file that receives
// what it prints (a descriptor).
void process_begin(const char *program, int printed);

// Starts it unless it is running. False, and errno, if that fails.
bool process_start(void);

// After it ended: 0 if the program had been started, else the error of the last step before that.
// The answer runs later, so it cannot forge one.
int process_start_error(void);
bool process_is_confined(void);

// Ends it. Its wait status if it ended by itself, within a moment; else -1.
int process_stop(bool wait_for_it);

// The seconds that it has worked, and those that one call may take: CALL_SECONDS, or 1.
double process_work(void);
double process_most_work(void);

// A call ends by the work that the process has done, not by the time that has passed: a busy
// machine must not fail a right answer. But a process that sleeps for some seconds waits in vain.
// If one could work but does not get a processor, the machine is at fault.
typedef enum { PATIENT, TOO_MUCH_WORK, WAITS_IN_VAIN, MACHINE_TOO_BUSY } PatienceEnd;
typedef struct {
    double work_before, work, since;
    int looks_asleep; // how often in a row it was found asleep
    PatienceEnd end;
} Patience;
Patience patience_begin(void);
bool patience_is_over(Patience *patience);

// Moves all bytes, out or in. 1 done, 0 waited too long, -1 the other end is closed.
int process_send(const void *bytes, size_t size, Patience *patience);
int process_receive(void *bytes, size_t size, Patience *patience);

// What a forbidden system call was for, in words: 'to open a file'. Of any number,
// because it comes from hostile code.
const char *system_call_purpose(int number);

// ---- a call (process_transport.c) ------------------------------------------------------------

// The process is started when it is first needed, and again after it crashed, hung or exited. A
// call without an answer ends the test, with the reason in words; later calls of the same exercise
// end their tests at once with the same reason, so that the judge waits only once for an endless
// loop.

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

#endif
