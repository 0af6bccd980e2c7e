// folder_lock.h - one at a time judges a folder of answers.
#ifndef TESTS_COURSE_FOLDER_LOCK_H
#define TESTS_COURSE_FOLDER_LOCK_H

// Waits until nobody else has the folder's lock, and says so on stderr if that is not at once. What
// comes back is given to folder_unlock; -1, and errno, if there can be no lock. The lock of a
// program that is killed is free.
int folder_lock(const char *folder);
void folder_unlock(int lock);

#endif
