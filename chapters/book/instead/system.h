// system.h - what WebAssembly's C library lacks; included in front of every file, in the place
// of pthread.h, sys/ioctl.h and sys/wait.h, which are empty.
#ifndef CHAPTERS_BOOK_INSTEAD_SYSTEM_H
#define CHAPTERS_BOOK_INSTEAD_SYSTEM_H

#include <stddef.h>
#include <sys/types.h>

pid_t getppid(void);
int kill(pid_t process, int number);
int execvp(const char *file, char *const words[]);
ssize_t getrandom(void *bytes, size_t size, unsigned flags);

// How a process ended: all of them exited.
#define WIFEXITED(status) ((status) >= 0)
#define WEXITSTATUS(status) ((status) >> 8)
#define WIFSIGNALED(status) ((void)(status), 0)
#define WTERMSIG(status) ((void)(status), 0)

// The width of a terminal: there is none, and the environment says how wide a line is.
struct winsize {
    unsigned short ws_row, ws_col, ws_xpixel, ws_ypixel;
};
#define TIOCGWINSZ 0
#define ioctl(file, request, into) ((void)(file), (void)(into), -1)

// Threads: there are none, so nobody waits for a lock (a page has a pool of Workers, cast/pool.js).
#define pthread_create(thread, how, run, given) (*(thread) = NULL, (void)(run), -1)
#define pthread_join(thread, into) ((void)(thread))
#define PTHREAD_MUTEX_INITIALIZER                                                                  \
    {                                                                                              \
        0                                                                                          \
    }
#define pthread_mutex_lock(mutex) ((void)(mutex))
#define pthread_mutex_unlock(mutex) ((void)(mutex))

#endif
