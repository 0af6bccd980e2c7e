// folder_lock.c - one at a time judges a folder of answers.
#include "tests/course/folder_lock.h"

#include "tests/course/judging_plan.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <sys/file.h>
#include <unistd.h>

int folder_lock(const char *folder)
{
    PlanPath path = path_of(folder, "lock", "");
    int lock = open(path.s, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (lock < 0)
        return -1;
    if (flock(lock, LOCK_EX | LOCK_NB) == 0)
        return lock;
    if (errno == EWOULDBLOCK)
        fprintf(stderr, "These answers are already being judged; waiting until that is done ...\n");
    while (flock(lock, LOCK_EX) != 0)
        if (errno != EINTR) {
            close(lock);
            return -1;
        }
    return lock;
}

void folder_unlock(int lock)
{
    if (lock >= 0)
        close(lock);
}
