// gnuplot.c - strings and numbers as gnuplot reads them.
#include "common/figure/gnuplot.h"

#include <stdio.h>
#include <stdlib.h>

char *gnuplot_string(const char *text, bool is_label)
{
    char *string;
    size_t size;
    FILE *out = open_memstream(&string, &size);
    putc('"', out);
    for (; *text != '\0'; text++) {
        if (*text == '"' || *text == '\\')
            putc('\\', out);
        if (*text == '-' && is_label)
            fputs("\u2212", out);
        else // a backquote would run what is between two of them
            putc((unsigned char)*text < ' ' ? ' ' : *text == '`' ? '\'' : *text, out);
    }
    putc('"', out);
    fclose(out);
    return string;
}

Text gnuplot_number(double x)
{
    enum { DIGITS = 12 };
    return isfinite(x) ? number_text_to(x, DIGITS) : (Text){"NaN"};
}
