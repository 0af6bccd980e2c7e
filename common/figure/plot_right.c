// plot_right.c - figures: the data by right answers, and whether yours say the same.
#include "common/figure/plot_internal.h"

#include <stdlib.h>
#include <string.h>

// From the end of key, which begins a line, up to end.
static size_t between(const Plot *plot, const char *key, const char *end, const char **begin)
{
    const char *found = plot->right != NULL ? strstr(plot->right, key) : NULL;
    if (found == NULL)
        return 0;
    *begin = found + strlen(key);
    const char *stop = strstr(*begin, end);
    return stop != NULL ? (size_t)(stop - *begin) : 0;
}

size_t plot_right_value(const Plot *plot, const char *name, const char **begin)
{
    char key[120];
    snprintf(key, sizeof key, "\n%s = ", name);
    return between(plot, key, "\n", begin);
}

// After the block's first line comes the comment that names its columns.
size_t plot_right_rows(const Plot *plot, const char *block, const char **begin)
{
    char key[120];
    snprintf(key, sizeof key, "\n$%s << EOD\n", block);
    size_t size = between(plot, key, "\nEOD\n", begin);
    const char *line = size > 0 ? strchr(*begin, '\n') : NULL;
    if (line == NULL)
        return 0;
    size++; // the last row's end
    size -= (size_t)(line + 1 - *begin);
    *begin = line + 1;
    return size;
}

// A number as in data or in a label. next points after it, or to its start if there is none.
static double number_at(const char *text, const char **next)
{
    bool minus = strncmp(text, "\u2212", strlen("\u2212")) == 0;
    const char *digits = text + (minus ? strlen("\u2212") : 0);
    char *end;
    double x = strtod(digits, &end);
    *next = end == digits ? text : end;
    if (end != digits && end[0] == 'e') // 1e−7
        x *= pow(10, number_at(end + 1, next));
    return minus ? -x : x;
}

bool plot_is_right(const char *right, size_t size, const char *yours)
{
    const char *end = right + size;
    while (right < end && *yours != '\0') {
        const char *right_next, *yours_next;
        double x = number_at(right, &right_next), y = number_at(yours, &yours_next);
        if ((right_next == right) != (yours_next == yours))
            return false;
        if (right_next == right) {
            if (*right++ != *yours++)
                return false;
            continue;
        }
        if (!(x == y || fabs(x - y) <= 1e-9 * (1 + fabs(x)) || (isnan(x) && isnan(y))))
            return false;
        right = right_next;
        yours = yours_next;
    }
    return right >= end && *yours == '\0';
}
