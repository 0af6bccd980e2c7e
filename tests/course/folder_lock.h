// folder_lock.h - one at a time judges a folder of answers.
#ifndef TESTS_COURSE_FOLDER_LOCK_H
#define TESTS_COURSE_FOLDER_LOCK_H

// Waits until nobody else has the folder's lock, and prints a message on stderr if it has to wait.
// Returns the argument of folder_unlock; or -1, and errno, if it cannot be locked. The lock of a
// program that is killed is free.
int folder_lock(const char *folder);
void folder_unlock(int lock);

#endif
