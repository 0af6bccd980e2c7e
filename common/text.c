// text.c - numbers to words and words to numbers.
#include "common/text.h"

#include "common/answers.h"

#include <ctype.h>
#include <float.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

static const char *read_digits(const char *text, uint64_t *digits)
{
    for (unsigned digit; (digit = (unsigned)*text - '0') < 10; text++)
        *digits = 10 * *digits + digit;
    return text;
}

// The same by eights: 8 bytes from the text on can be read. The values of 8 digits are added in
// pairs, fours and eights, all at once in one number; there is no loop whose end the processor
// would have to predict. (The first byte in memory is the lowest one here.)
static const char *read_digits_by_8(const char *text, uint64_t *digits)
{
    static const uint64_t powers[] = {1,      10,      100,      1000,     10000,
                                      100000, 1000000, 10000000, 100000000};
    for (unsigned count = 8; count == 8; text += count) {
        uint64_t values;
        memcpy(&values, text, sizeof values);
        values ^= 0x3030303030303030;
        uint64_t others = (values | (values + 0x0606060606060606)) & 0xf0f0f0f0f0f0f0f0;
        count = others == 0 ? 8 : (unsigned)__builtin_ctzll(others) / 8;
        values = count == 0 ? 0 : values << (64 - 8 * count);
        values = (10 * values + (values >> 8)) & 0x00ff00ff00ff00ff;
        values = (100 * values + (values >> 16)) & 0x0000ffff0000ffff;
        values = (10000 * values + (values >> 32)) & 0x00000000ffffffff;
        *digits = *digits * powers[count] + values;
    }
    return text;
}

// The power of ten after an 'e', added to *power; NULL if it is not a number, or a large one.
static const char *read_power(const char *text, int *power)
{
    bool negative = *text == '-';
    text += negative || *text == '+';
    uint64_t digits = 0;
    const char *end = read_digits(text, &digits);
    if (end == text || end - text > 4)
        return NULL;
    *power += negative ? -(int)digits : (int)digits;
    return end;
}

// strtod for most of what is written down, and much quicker: the digits without their point are a
// whole number, and that and a power of ten up to 22 are doubles without any rounding; so that one
// multiplication or division of the two rounds once, as strtod does (Clinger, 'How to Read Floating
// Point Numbers Accurately', 1990). NULL where it is not so simple, or no number.
static inline const char *read_short_number(const char *text, double *number, bool padded)
{
    static const double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                    1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                    1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    static const double signs[] = {1, -1};
    enum { MOST_DIGITS = 19, MOST_POWER = 22 }; // 19 digits fit in 64 bits
    bool negative = *text == '-';
    text += negative || *text == '+';
    uint64_t digits = 0;
    const char *end = read_digits(text, &digits);
    long count = end - text;
    int power = 0;
    if (*end == '.') {
        const char *fraction = end + 1;
        end = padded ? read_digits_by_8(fraction, &digits) : read_digits(fraction, &digits);
        count += end - fraction;
        power = -(int)(end - fraction);
    }
    if (count == 0 || count > MOST_DIGITS || digits > (uint64_t)1 << DBL_MANT_DIG)
        return NULL;
    if ((*end == 'e' || *end == 'E') && (end = read_power(end + 1, &power)) == NULL)
        return NULL;
    if (power < -MOST_POWER || power > MOST_POWER || *end == 'x' || *end == 'X')
        return NULL;
    double value = (double)digits;
    value = power < 0 ? value / powers[-power] : value * powers[power];
    *number = signs[negative] * value; // no branch: no processor can predict a sign
    return end;
}

// If doubles are computed with more digits than they hold, they are rounded twice.
#define IS_ROUNDED_ONCE (FLT_EVAL_METHOD == 0)

const char *read_padded_number(const char *text, double *number)
{
    const bool padded = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__;
    const char *end = IS_ROUNDED_ONCE ? read_short_number(text, number, padded) : NULL;
    return end != NULL ? end : read_number(text, number);
}

const char *read_number(const char *text, double *number)
{
    const char *short_end = IS_ROUNDED_ONCE ? read_short_number(text, number, false) : NULL;
    if (short_end != NULL)
        return short_end;
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
