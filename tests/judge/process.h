// process.h - the answering process: its beginning and end, its pipes, and the patience with it.
#ifndef TESTS_JUDGE_PROCESS_H
#define TESTS_JUDGE_PROCESS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

// A file for what the answers print, that takes no room on a disk where that can be had. NULL, and
// errno, if there is none.
FILE *process_printed_file(void);

// What is started, through confine where the environment has CONFINE; and the file that catches
// what it prints (a descriptor).
void process_begin(const char *program, int printed);

// Starts it where it is not running. False, and errno, where that fails.
bool process_start(void);

// After it ended: 0 if the program had been started, else the error of the last step before that.
// What an answer does comes later, so it cannot forge one.
int process_start_error(void);
bool process_is_confined(void);

// Ends it. Its wait status where it ended by itself, within a moment; else -1.
int process_stop(bool wait_for_it);

// The seconds that it has worked, and those that one call may take: CALL_SECONDS, or 1.
double process_work(void);
double process_most_work(void);

// What ends a call: the work that it has done, not the time that has passed, or a busy machine
// would fail a right answer. But a process that sleeps for some seconds waits in vain. One that
// could work and is not given a processor is the machine's fault.
typedef enum { PATIENT, TOO_MUCH_WORK, WAITS_IN_VAIN, MACHINE_TOO_BUSY } PatienceEnd;
typedef struct {
    double work_before, work, since;
    int looks_asleep; // how often in a row it was seen asleep
    PatienceEnd end;
} Patience;
Patience patience_begin(void);
bool patience_is_over(Patience *patience);

// Moves all bytes, out or in. 1 done, 0 the patience is over, -1 the other end is closed.
int process_send(const void *bytes, size_t size, Patience *patience);
int process_receive(void *bytes, size_t size, Patience *patience);

#endif
