// pthread.h - locks for programs in a page, where nobody else runs.
#ifndef CHAPTERS_BOOK_INSTEAD_PTHREAD_H
#define CHAPTERS_BOOK_INSTEAD_PTHREAD_H

#include <sys/types.h> // pthread_mutex_t

#define PTHREAD_MUTEX_INITIALIZER {0}
#define pthread_mutex_lock(mutex) ((void)(mutex))
#define pthread_mutex_unlock(mutex) ((void)(mutex))

#endif
