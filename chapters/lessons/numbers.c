// numbers.c - the numbers of a lesson by their names (fill.h).
#include "chapters/lessons/fill.h"

#include "common/shown.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_NAMES = 100 };

static FilledNumber values[MOST_NAMES];
static int value_count;

void fill_text(const char *name, const char *format, ...)
{
    if (value_count == MOST_NAMES) {
        fprintf(stderr, "%s: there is room for %d names only\n", name, MOST_NAMES);
        exit(2);
    }
    FilledNumber *value = &values[value_count++];
    value->name = name;
    va_list list;
    va_start(list, format);
    vsnprintf(value->text, sizeof value->text, format, list);
    va_end(list);
}

void fill_number(const char *name, double x)
{
    fill_text(name, "%s", number_shown(x).s);
}

void fill_number_to(const char *name, double x, int digits)
{
    fill_text(name, "%s", number_shown_to(x, digits).s);
}

void fill_vector(const char *name, vec3 v)
{
    fill_text(name, "%s", vec3_shown(v).s);
}

void fill_term(const char *name, double x)
{
    fill_text(name, "%s %s", x < 0 ? "\u2212" : "+", number_shown(fabs(x)).s);
}

static bool is_exact(double x)
{
    enum { MOST = 12 };
    return strcmp(number_shown(x).s, number_shown_to(x, MOST).s) == 0;
}

static const char *equals(bool exact)
{
    return exact ? "=" : "\\approx";
}

void fill_equals(const char *name, int count, const double *numbers)
{
    bool exact = true;
    for (int i = 0; i < count; i++)
        exact = exact && is_exact(numbers[i]);
    fill_text(name, "%s", equals(exact));
}

void fill_result(const char *name, double x, int digits)
{
    fill_text(name, "%s %s", equals(is_exact(x)), number_shown_to(x, digits).s);
}

void fill_option(const char *name, vec3 v)
{
    fill_text(name, "%s,%s,%s", number_text(v[0]).s, number_text(v[1]).s, number_text(v[2]).s);
}

void fill_camera(Camera c)
{
    fill_number("d", c.distance);
    fill_number("w", c.width);
    fill_number("h", c.height);
    fill_vector("eye", c.origin);
    fill_vector("right", c.right);
    fill_vector("up", c.up);
    fill_vector("forward", c.forward);
}

const FilledNumber *filled_numbers(int *count)
{
    *count = value_count;
    return values;
}
