// no_processes.h - declarations that the C library lacks; included in front of every file.
#ifndef CHAPTERS_BOOK_INSTEAD_NO_PROCESSES_H
#define CHAPTERS_BOOK_INSTEAD_NO_PROCESSES_H

#include <stddef.h>
#include <sys/types.h>

pid_t getppid(void);
int kill(pid_t process, int number);
int execvp(const char *file, char *const words[]);
ssize_t getrandom(void *bytes, size_t size, unsigned flags);

#endif
