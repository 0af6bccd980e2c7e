// progress.h - long work says on stderr how far it is, and how long it will still take.
#ifndef COMMON_PROGRESS_H
#define COMMON_PROGRESS_H

#include "common/text.h"

#include <stdbool.h>

typedef struct {
    const char *what; // "figures"
    long all;         // how many there are
    bool in_logs;     // also where stderr is not a terminal
    bool shown;       // a terminal has a line now
    double began, last;
} Progress;

// Begins now. On a terminal one line is shown after the first second, and changes twice a second. A
// log gets a line after two seconds, and then one every ten.
Progress progress_begin(const char *what, long all, bool in_logs);

// So many are done. May be called as often as there is something to say.
void progress_show(Progress *progress, long done);

// Removes the line from a terminal.
void progress_end(Progress *progress);

// 19 % (320 of 1624), about 3 min 20 s left
Text progress_text(long done, long all, double seconds);

#endif
