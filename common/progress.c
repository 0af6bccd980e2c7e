// progress.c - long work says on stderr how far it is.
#include "common/progress.h"

#include "common/clock.h"
#include "common/text.h"

#include <stdio.h>
#include <unistd.h>

Progress progress_begin(const char *what, long all)
{
    return (Progress){.what = what, .all = all, .began = clock_seconds()};
}

// 19 % (320 of 1624), about 3 min 20 s left
static Text progress_text(long done, long all, double seconds)
{
    Text text;
    if (done <= 0 || done > all) // a student's loop may do more than there is to do
        snprintf(text.s, sizeof text.s, "%ld so far, after %.60s", done, duration_text(seconds).s);
    else
        snprintf(text.s, sizeof text.s, "%ld %% (%ld of %ld), about %.60s left", 100 * done / all,
                 done, all, duration_text(seconds * (double)(all - done) / (double)done).s);
    return text;
}

void progress_show(Progress *progress, long done)
{
    static const double first = 1, then = 0.5; // seconds
    double seconds = clock_seconds() - progress->began;
    if (!isatty(STDERR_FILENO) ||
        (progress->last == 0 ? seconds < first : seconds - progress->last < then))
        return;
    progress->last = seconds;
    fprintf(stderr, "\r  %-9s %s\033[K", progress->what,
            progress_text(done, progress->all, seconds).s);
}

void progress_end(Progress *progress)
{
    if (progress->last != 0)
        fprintf(stderr, "\r\033[K");
    progress->last = 0;
}
