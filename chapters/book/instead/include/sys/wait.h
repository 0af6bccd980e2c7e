// wait.h - how a process ended; here all of them exited.
#ifndef CHAPTERS_BOOK_INSTEAD_WAIT_H
#define CHAPTERS_BOOK_INSTEAD_WAIT_H

#define WIFEXITED(status) ((status) >= 0)
#define WEXITSTATUS(status) ((status) >> 8)
#define WIFSIGNALED(status) ((void)(status), 0)
#define WTERMSIG(status) ((void)(status), 0)

#endif
