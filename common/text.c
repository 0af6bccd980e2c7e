// text.c - numbers to words and words to numbers.
#include "common/text.h"

#include "common/answers.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

Text number_text_to(double x, int digits)
{
    Text text;
    if (isnan(x) && answers_missing() > 0)
        snprintf(text.s, sizeof text.s, "not answered yet");
    else if (isnan(x)) // which sign it has depends on the machine
        snprintf(text.s, sizeof text.s, "nan");
    else
        snprintf(text.s, sizeof text.s, "%.*g", digits, x == 0 ? 0.0 : x);
    return text;
}

Text number_text(double x)
{
    return number_text_to(x, TEXT_DIGITS);
}

Text vec3_text_to(vec3 v, int digits)
{
    if (isnan(v[0]) && answers_missing() > 0)
        return number_text(v[0]);
    Text text;
    snprintf(text.s, sizeof text.s, "(%.40s, %.40s, %.40s)", number_text_to(v[0], digits).s,
             number_text_to(v[1], digits).s, number_text_to(v[2], digits).s);
    return text;
}

Text vec3_text(vec3 v)
{
    return vec3_text_to(v, TEXT_DIGITS);
}

Text pair_text(double x, double y)
{
    if (isnan(x) && answers_missing() > 0)
        return number_text(x);
    Text text;
    snprintf(text.s, sizeof text.s, "(%.40s, %.40s)", number_text(x).s, number_text(y).s);
    return text;
}

Text text_of(const char *format, ...)
{
    Text text;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text.s, sizeof text.s, format, arguments);
    va_end(arguments);
    return text;
}

Text duration_text(double seconds)
{
    enum { DIGITS = 3, MINUTE = 60, HOUR = 3600 };
    Text text;
    // What would be rounded up to the next unit has that one.
    if (!(fabs(seconds) >= 0.9995)) {
        snprintf(text.s, sizeof text.s, "%.40s ms", number_text_to(1e3 * seconds, DIGITS).s);
    } else if (!(seconds >= 59.95 && seconds < 1e12)) {
        snprintf(text.s, sizeof text.s, "%.40s s", number_text_to(seconds, DIGITS).s);
    } else {
        bool hours = seconds >= HOUR - 0.5;
        long small = hours ? MINUTE : 1, large = hours ? HOUR : MINUTE;
        long count = lround(seconds / (double)small) * small;
        int used = snprintf(text.s, sizeof text.s, "%ld %s", count / large, hours ? "h" : "min");
        if (count % large > 0)
            snprintf(text.s + used, sizeof text.s - (size_t)used, " %ld %s", count % large / small,
                     hours ? "min" : "s");
    }
    return text;
}

Text word_text(const char *word)
{
    enum { LONGEST = 40 };
    Text text;
    int n = 0;
    for (; word[n] != '\0' && n < LONGEST; n++)
        text.s[n] = word[n];
    snprintf(text.s + n, sizeof text.s - (size_t)n, "%s", word[n] == '\0' ? "" : "...");
    for (char *c = text.s; *c != '\0'; c++)
        if ((unsigned char)*c < ' ' || (unsigned char)*c >= 127)
            *c = '?';
    return text;
}

// strtod reads more than a scene may say: leading space, 0x1p3, inf, nan. So look first.
static bool begins_as_a_number(const char *text)
{
    if (*text == '+' || *text == '-')
        text++;
    if (text[0] == '0' && (text[1] == 'x' || text[1] == 'X'))
        return false;
    if (*text == '.')
        text++;
    return isdigit((unsigned char)*text) != 0;
}

const char *read_number(const char *text, double *number)
{
    if (!begins_as_a_number(text))
        return NULL;
    char *end;
    double value = strtod(text, &end);
    if (!isfinite(value))
        return NULL;
    *number = value;
    return end;
}

bool message_set(Message *message, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message->text, sizeof message->text, format, arguments);
    va_end(arguments);
    return false;
}

void json_print_string(FILE *out, const char *text)
{
    putc('"', out);
    for (; *text != '\0'; text++)
        if (*text == '\n')
            fputs("\\n", out);
        else
            fprintf(out, *text == '"' || *text == '\\' ? "\\%c" : "%c", *text);
    putc('"', out);
}
