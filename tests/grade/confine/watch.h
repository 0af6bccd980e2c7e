// watch.h - nothing that a command started outlives it, or whoever wanted it.
#ifndef TESTS_GRADE_CONFINE_WATCH_H
#define TESTS_GRADE_CONFINE_WATCH_H

#include <sys/types.h>

// Runs the command and ends as it does, with all that is left of it; at once if the parent ends,
// however that ends. parent: the process that wants the command, which may have ended by now.
_Noreturn void watch(pid_t parent, char **command);

#endif
