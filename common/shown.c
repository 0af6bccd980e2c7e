// shown.c - numbers as people write them.
#include "common/shown.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// The most digits of a number that has no more.
enum { SHORT = 6 };

// The powers of ten that are not written.
enum { LEAST_POWER = -4, MOST_POWER = 6 };

// Is x, but for rounding, a number of so many digits?
static bool has_only(double x, int digits)
{
    char text[64];
    snprintf(text, sizeof text, "%.*e", digits - 1, x);
    return fabs(strtod(text, NULL) - x) <= 1e-9 * fabs(x);
}

static int larger(int a, int b)
{
    return a > b ? a : b;
}

static int digits_of(double x, int digits)
{
    int power = (int)floor(log10(fabs(x))), before_point = power + 1;
    if (power < LEAST_POWER || power > MOST_POWER)
        return digits;
    return has_only(x, larger(digits, SHORT)) ? larger(digits, SHORT)
                                              : larger(digits, before_point);
}

// The digits of x, rounded, without zeros at their end; and the power of ten of the first.
static void take_apart(double x, int digits, char number[32], int *power)
{
    char text[64];
    snprintf(text, sizeof text, "%.*e", (digits < 17 ? digits : 17) - 1, fabs(x));
    size_t count = 0;
    const char *c = text;
    for (; *c != 'e'; c++)
        if (*c != '.')
            number[count++] = *c;
    while (count > 1 && number[count - 1] == '0')
        count--;
    number[count] = '\0';
    *power = atoi(c + 1);
}

static void add(Text *text, const char *more)
{
    size_t used = strlen(text->s);
    snprintf(text->s + used, sizeof text->s - used, "%s", more);
}

static void add_digit(Text *text, char digit)
{
    add(text, (const char[]){digit, '\0'});
}

// Thousands are apart in 10,000 and above, as in 1920 they are not.
static void add_plain(Text *text, const char *number, int power)
{
    enum { THOUSAND = 3 };
    int count = (int)strlen(number);
    add(text, power < 0 ? "0." : "");
    for (int i = power; i < -1; i++)
        add(text, "0");
    for (int i = 0; i < count || i <= power; i++) {
        if (i > 0 && i == power + 1)
            add(text, ".");
        else if (i > 0 && i <= power && power > THOUSAND && (power + 1 - i) % THOUSAND == 0)
            add(text, ",");
        add_digit(text, i < count ? number[i] : '0');
    }
}

static void add_power(Text *text, const char *number, int power)
{
    static const char *const raised[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                         "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    char digits[16];
    if (strcmp(number, "1") != 0) {
        add_digit(text, number[0]);
        add(text, number[1] != '\0' ? "." : "");
        add(text, number + 1);
        add(text, " \u00b7 ");
    }
    add(text, power < 0 ? "10\u207b" : "10");
    snprintf(digits, sizeof digits, "%d", abs(power));
    for (const char *c = digits; *c != '\0'; c++)
        add(text, raised[*c - '0']);
}

Text number_shown_to(double x, int digits)
{
    if (isnan(x))
        return number_text(x);
    if (x == 0)
        return (Text){"0"};
    Text text = {""};
    add(&text, x < 0 ? "\u2212" : "");
    if (isinf(x)) {
        add(&text, "\u221e");
        return text;
    }
    char number[32];
    int power;
    take_apart(x, digits_of(x, digits), number, &power);
    if (power < LEAST_POWER || power > MOST_POWER)
        add_power(&text, number, power);
    else
        add_plain(&text, number, power);
    return text;
}

Text number_shown(double x)
{
    return number_shown_to(x, SHOWN_DIGITS);
}

Text pair_shown_to(double x, double y, int digits)
{
    Text text;
    if (isnan(x))
        return number_text(x);
    snprintf(text.s, sizeof text.s, "(%.60s, %.60s)", number_shown_to(x, digits).s,
             number_shown_to(y, digits).s);
    return text;
}

Text pair_shown(double x, double y)
{
    return pair_shown_to(x, y, SHOWN_DIGITS);
}

Text vec3_shown_to(vec3 v, int digits)
{
    Text text;
    double rounding = 1e-13 * vec3_length(v);
    if (isnan(v[0]))
        return number_text(v[0]);
    for (int i = 0; i < 3; i++)
        v[i] = fabs(v[i]) <= rounding && isfinite(rounding) ? 0 : v[i];
    snprintf(text.s, sizeof text.s, "(%.48s, %.48s, %.48s)", number_shown_to(v[0], digits).s,
             number_shown_to(v[1], digits).s, number_shown_to(v[2], digits).s);
    return text;
}

Text vec3_shown(vec3 v)
{
    return vec3_shown_to(v, SHOWN_DIGITS);
}
