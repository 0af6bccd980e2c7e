// override-blanks: replaces the notes about blanks, so that a blank is never one.
// stem: 01-corners
// expect: graded | does not compile | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <string.h>

void *not_answered(const char *function, const char *file, void *value, size_t size)
{
    return memset(value, 0, size);
}

int answers_missing(void)
{
    return 0;
}

const char *answer_missing(int i)
{
    return "";
}

void answers_forget(void)
{
}

int answers_report(void)
{
    return 0;
}
