// progress.h - long work says on a terminal how far it is, and how long it will still take.
#ifndef COMMON_PROGRESS_H
#define COMMON_PROGRESS_H

typedef struct {
    const char *what; // "pixels"
    long all;         // how many there are
    double began, last;
} Progress;

// Begins now. One line is shown after the first second, and changes twice a second.
Progress progress_begin(const char *what, long all);

// So many are done. May be called as often as there is something to say.
void progress_show(Progress *progress, long done);

// Removes the line.
void progress_end(Progress *progress);

#endif
