// landlock.h - what of the file system, the network and other processes can be reached.
#ifndef TESTS_GRADE_CONFINE_LANDLOCK_H
#define TESTS_GRADE_CONFINE_LANDLOCK_H

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

#endif
