// progress.c - long work says on stderr how far it is.
#include "common/progress.h"

#include "common/clock.h"

#include <stdio.h>
#include <unistd.h>

Progress progress_begin(const char *what, long all, bool in_logs)
{
    return (Progress){.what = what, .all = all, .in_logs = in_logs, .began = clock_seconds()};
}

Text progress_text(long done, long all, double seconds)
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
    static const double first[] = {2, 1}, then[] = {10, 0.5};
    bool terminal = isatty(STDERR_FILENO);
    double seconds = clock_seconds() - progress->began;
    bool begins = progress->last == 0;
    if ((!terminal && !progress->in_logs) ||
        (begins ? seconds < first[terminal] : seconds - progress->last < then[terminal]))
        return;
    progress->last = seconds;
    progress->shown = terminal;
    fprintf(stderr, "%s  %-9s %s%s", terminal ? "\r" : "", progress->what,
            progress_text(done, progress->all, seconds).s, terminal ? "\033[K" : "\n");
}

void progress_end(Progress *progress)
{
    if (progress->shown)
        fprintf(stderr, "\r\033[K");
    progress->shown = false;
}
