// watch.h - judges answers again whenever they are saved.
#ifndef TESTS_COURSE_WATCH_H
#define TESTS_COURSE_WATCH_H

#include <stdbool.h>

// A file counts as saved when its text is another than before: dates are unreliable, and editors
// write twice. Whoever watches begins before the texts are judged first, so that no save is lost.
typedef struct Watch Watch;

// Watches these files of a folder. By inotify, if it is there and the environment does not have
// POLL; in any case it also looks by itself, more rarely (network drives send no events).
Watch *watch_begin(const char *folder, int count, const char *const *files);
void watch_end(Watch *watch);

// Waits until one of them has another text than when it was last given here, or at the beginning.
// Its number; -1 if the process that has started this one is gone.
int watch_next(Watch *watch);

#endif
