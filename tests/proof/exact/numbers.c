// numbers.c - read_number and read_padded_number against strtod: the same double to the bit, and
// the same end.
//
// Usage: numbers [COUNT]: COUNT numbers of each kind (20000). Simple numbers are read by one
// multiplication or division (common/text.c); here it is held against the C library's own, which
// rounds correctly. The last line counts kinds.
#include "common/text.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    char s[1400];
} Written;

// SplitMix64 (Steele, Lea and Flood, 2014).
static uint64_t state = 1;
static uint64_t bits(void)
{
    uint64_t z = state += 0x9e3779b97f4a7c15;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return z ^ z >> 31;
}

static int from_to(int low, int high)
{
    return low + (int)(bits() % (uint64_t)(high - low + 1));
}

static double uniform(double low, double high)
{
    return low + (high - low) * (double)(bits() >> 11) * 0x1p-53;
}

// ---- kinds of numbers -------------------------------------------------------------------------

static void of_a_scene(Written *to)
{
    snprintf(to->s, sizeof to->s, "%.12g", uniform(-2, 2) * pow(10, from_to(-6, 3)));
}

static void of_some_digits(Written *to)
{
    snprintf(to->s, sizeof to->s, "%.*g", from_to(1, 19),
             uniform(-1, 1) * pow(10, from_to(-30, 30)));
}

static void with_a_point(Written *to)
{
    snprintf(to->s, sizeof to->s, "%.*f", from_to(0, 20), uniform(-1, 1) * pow(10, from_to(-5, 9)));
}

// Any double there is, to the digits that tell it from its neighbours, and one or two fewer.
static void any_double(Written *to)
{
    uint64_t b = bits();
    double x;
    memcpy(&x, &b, sizeof x);
    snprintf(to->s, sizeof to->s, "%.*g", from_to(15, 17), isfinite(x) ? x : 0.1);
}

static void any_digits(Written *to)
{
    char *c = to->s;
    int count = from_to(1, 24), point = from_to(-1, count);
    if (bits() % 3 == 0)
        *c++ = bits() % 2 == 0 ? '-' : '+';
    int zeros = bits() % 2 == 0 ? from_to(0, count) : 0;
    for (int i = 0; i < count; i++) {
        if (i == point)
            *c++ = '.';
        *c++ = i < zeros ? '0' : (char)('0' + from_to(0, 9));
    }
    if (point == count)
        *c++ = '.';
    *c = '\0';
    if (bits() % 2 == 0)
        sprintf(c, "%c%s%0*d", bits() % 2 == 0 ? 'e' : 'E', bits() % 2 == 0 ? "-" : "",
                from_to(1, 3), from_to(0, 30));
}

// Whole numbers next to 2^53, beyond which not all are doubles, times powers next to 10^22, beyond
// which none are.
static void at_the_limits(Written *to)
{
    long long whole = (1LL << 53) + from_to(-300, 300);
    snprintf(to->s, sizeof to->s, "%llde%d", bits() % 2 == 0 ? whole : (long long)(bits() >> 11),
             from_to(-25, 25));
}

// In the middle of two whole doubles, or a digit beside it: x.5 with 53 bits before the point.
static void in_the_middle(Written *to)
{
    static const char *const fractions[] = {"5", "49999999999999999999999", "50000000000000001"};
    long long whole = (long long)(bits() >> 11 | 1ULL << 52);
    snprintf(to->s, sizeof to->s, "%lld.%s", whole, fractions[bits() % 3]);
}

static const struct {
    const char *name;
    void (*write)(Written *to);
} kinds[] = {{"as scenes are written", of_a_scene},
             {"of some digits", of_some_digits},
             {"with a point", with_a_point},
             {"any double", any_double},
             {"any digits", any_digits},
             {"at the limits", at_the_limits},
             {"in the middle", in_the_middle}};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

static bool agrees(const char *text, const char *(*read)(const char *text, double *number))
{
    char *expected_end;
    double expected = strtod(text, &expected_end), number = 0;
    const char *end = read(text, &number);
    if (isinf(expected))
        return end == NULL;
    return end == expected_end && memcmp(&number, &expected, sizeof number) == 0;
}

int main(int argc, char **argv)
{
    static const char *const behind[] = {"", " 1", "\n", "y", "e", "e+", "-1", ",", "..", "#"};
    long count = argc > 1 ? atol(argv[1]) : 20000;
    int failed = 0;
    for (int kind = 0; kind < KINDS; kind++) {
        bool good = true;
        for (long i = 0; i < count && good; i++) {
            Written text;
            kinds[kind].write(&text);
            strcat(text.s, behind[bits() % 10]);
            good = agrees(text.s, read_number) && agrees(text.s, read_padded_number);
            if (!good)
                printf("not ok: numbers, %s: '%s'\n", kinds[kind].name, text.s);
        }
        failed += !good;
    }
    printf("numbers: %d passed, %d failed\n", KINDS - failed, failed);
    return failed > 0;
}
