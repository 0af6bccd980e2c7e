// system_calls.h - which system calls are left, for this process and all that it starts.
#ifndef TESTS_GRADE_CONFINE_SYSTEM_CALLS_H
#define TESTS_GRADE_CONFINE_SYSTEM_CALLS_H

// A student's answers: memory, mathematics, their pipes (read 3, write 1, 2 and 4). Anything else
// ends the process with SIGSYS. It can be started once, from this descriptor.
void allow_answers(int program);

// A compiler: all but what only an attack on the compiler itself would want. It runs no code of the
// student's.
void allow_compiler(void);

#endif
