// programs.h - runs programs, and ends them when this one is ended.
#ifndef TESTS_COURSE_PROGRAMS_H
#define TESTS_COURSE_PROGRAMS_H

#include <stdbool.h>

// From now on Ctrl-C, a closed terminal or kill ends what was started, then this program.
void programs_end_with_us(void);
// From now on Ctrl-C is the end that is expected: exit status 0, so that make has no error to
// print.
void programs_end_as_usual_by_interrupt(void);

// Whether there is a program of this name in PATH.
bool program_is_there(const char *name);

// Runs a program: its name and its arguments, then NULL. Its input comes from /dev/null, its output
// goes into a file (NULL: to our own output). The system ends it after this many seconds of
// processor time (0: never). Its exit status; 128 and more after a signal; 127 if it cannot be
// started. V=1 in the environment shows the command.
int program_run(char *const *words, const char *output, int seconds);

#endif
