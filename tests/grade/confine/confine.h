// confine.h - what confine.c is made of.
#ifndef TESTS_GRADE_CONFINE_CONFINE_H
#define TESTS_GRADE_CONFINE_CONFINE_H

#include <sys/types.h>

// What cannot be confined is not started: says what failed, and errno's reason; exit status 126.
_Noreturn void give_up(const char *what);

// landlock.c - what of the file system, the network and other processes can be reached.
//
// The version of Landlock in this kernel; 0: none.
int landlock_version(void);
// A set of rules that allows nothing yet (a descriptor); what is allowed is added; then it holds
// for this process and all that it starts, for good. Rules that this system lacks are left
// out.
int landlock_begin(void);
void landlock_allow_read(int rules, const char *path); // and to execute
void landlock_allow_all(int rules, const char *path);
void landlock_allow_program(int rules, int file); // an open file: to be started
void landlock_end(int rules);

// system_calls.c - which system calls are left, for this process and all that it starts.
//
// A student's answers: memory, mathematics, their pipes (read 3, write 1, 2 and 4). Anything else
// ends the process with SIGSYS. It can be started once, from this descriptor.
void allow_answers(int program);
// A compiler: all but what only an attack on the compiler itself would want. It runs no code of the
// student's.
void allow_compiler(void);

// watch.c - how what is started ends, and whether processes can be started at all.
//
// Runs the command and ends as it does, with all that is left of it; at once if the parent ends,
// however that ends. parent: the process that wants the command, which may have ended by now.
_Noreturn void watch(pid_t parent, char **command);
// The exit statuses of run_tool, as tests/grade/mark/commands.py reads them. All but the last are
// due to the text that was compiled.
enum {
    TOOL_REFUSES = 90, // exit status 1: it says what is wrong with the text
    TOOL_WORK = 91,    // more work than the limit
    TOOL_FILE = 92,    // a larger file than the limit
    TOOL_CRASHED = 93, // a fault of its own: memory, stack, assertion
    TOOL_ODD = 94,     // another exit status: it found an error in itself
    TOOL_ENDED = 99,   // ended by somebody else, or could not be started
};
// Runs the command and waits for it.
int run_tool(char **command);
// 0 if that number of processes can exist at a time.
int room_for(int processes);

#endif
