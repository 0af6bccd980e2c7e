// options.c - command lines, on top of getopt_long.
#include "common/options.h"

#include "common/image.h"
#include "common/screen.h"
#include "common/text.h"

#include <errno.h>
#include <getopt.h>
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// ---- was all printed? ---------------------------------------------------------------------------

static const char *name;

// If a full buffer could not be written earlier, only ferror knows it, without the reason.
static void check(void)
{
    errno = 0;
    bool flushed = fflush(stdout) == 0;
    if (flushed && !ferror(stdout))
        return;
    fprintf(stderr, "%s: cannot print: %s\n", name,
            errno != 0 ? strerror(errno) : "standard output was not written");
    _exit(EXIT_COULD_NOT);
}

void printed_or_failed(const char *program)
{
    name = program;
    atexit(check);
}

// ---- options ------------------------------------------------------------------------------------

enum { MOST_OPTIONS = 24 };

bool option_flag(const char *text, void *into)
{
    (void)text;
    *(bool *)into = true;
    return true;
}

bool option_string(const char *text, void *into)
{
    *(const char **)into = text;
    return *text != '\0';
}

// The fifth powers of these are still numbers, so what the programs print is never infinite or NaN.
static const double LARGEST = 1e60, SMALLEST = 1e-60;
static const char *out_of_range; // why the last numbers were refused; NULL if they were no numbers

// Exactly count numbers, with commas between.
static bool read_numbers(const char *text, double *numbers, int count)
{
    out_of_range = NULL;
    for (int i = 0; i < count; i++) {
        text = read_number(text, &numbers[i]);
        if (text == NULL || *text != (i < count - 1 ? ',' : '\0'))
            return false;
        text++;
    }
    for (int i = 0; i < count; i++)
        if (fabs(numbers[i]) > LARGEST)
            out_of_range = "is too large, expected at most 1e60";
        else if (numbers[i] != 0 && fabs(numbers[i]) < SMALLEST)
            out_of_range = "is too small, expected 0 or at least 1e-60";
    return out_of_range == NULL;
}

bool option_number(const char *text, void *into)
{
    return read_numbers(text, into, 1);
}

bool option_vec3(const char *text, void *into)
{
    double v[3];
    if (!read_numbers(text, v, 3))
        return false;
    *(vec3 *)into = vec3_of(v[0], v[1], v[2]);
    return true;
}

bool option_pair(const char *text, void *into)
{
    return read_numbers(text, into, 2);
}

// A whole number from least to most; what follows it, or NULL.
static const char *read_whole(const char *text, int least, int most, int *number)
{
    if (*text < '0' || *text > '9')
        return NULL;
    char *end;
    long n = strtol(text, &end, 10);
    *number = (int)n;
    return n < least || n > most ? NULL : end;
}

bool option_whole(const char *text, int least, int most, int *number)
{
    const char *end = read_whole(text, least, most, number);
    return end != NULL && *end == '\0';
}

// Two of them, with a separator between.
static bool read_two(const char *text, char separator, int least, int most, int numbers[2])
{
    const char *end = read_whole(text, least, most, &numbers[0]);
    return end != NULL && *end == separator && option_whole(end + 1, least, most, &numbers[1]);
}

bool option_pixel(const char *text, void *into)
{
    int n[2];
    if (!read_two(text, ',', 0, IMAGE_MAX_SIDE - 1, n))
        return false;
    *(Pixel *)into = (Pixel){n[0], n[1]};
    return true;
}

bool option_size(const char *text, void *into)
{
    int n[2];
    if (!read_two(text, 'x', 1, IMAGE_MAX_SIDE, n))
        return false;
    *(Resolution *)into = (Resolution){n[0], n[1]};
    return true;
}

void options_wrong(const char *program, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fprintf(stderr, "%s: ", program);
    vfprintf(stderr, format, arguments);
    fprintf(stderr, "\nTry '%s --help'.\n", program);
    va_end(arguments);
    exit(EXIT_WRONG_USAGE);
}

static void print_help(const char *program, const Option *options, Usage usage)
{
    printf("Usage: %s %s\n\n%s\n\n", program, usage.synopsis, usage.purpose);
    for (const Option *o = options; o->name != NULL; o++) {
        char left[64];
        if (o->help == NULL)
            continue;
        if (o->letter != 0)
            snprintf(left, sizeof left, "-%c, --%s", o->letter, o->name);
        else
            snprintf(left, sizeof left, "    --%s", o->name);
        size_t used = strlen(left);
        if (o->expected != NULL)
            snprintf(left + used, sizeof left - used, " %s", o->expected);
        printf("  %-28s %s\n", left, o->help);
    }
    printf("  %-28s %s\n", "-h, --help", "this");
}

int options_read(int argc, char **argv, const Option *options, Usage usage)
{
    struct option longs[MOST_OPTIONS + 2];
    char shorts[2 * MOST_OPTIONS + 3] = ":h"; // ':' so that getopt tells a missing value apart
    char *end = shorts + strlen(shorts);
    int count = 0;
    for (; options[count].name != NULL && count < MOST_OPTIONS; count++) {
        const Option *o = &options[count];
        int takes = o->expected != NULL ? required_argument : no_argument;
        longs[count] = (struct option){o->name, takes, NULL, 256 + count};
        if (o->letter != 0)
            *end++ = o->letter;
        if (o->letter != 0 && o->expected != NULL)
            *end++ = ':';
    }
    longs[count] = (struct option){"help", no_argument, NULL, 256 + count};
    longs[count + 1] = (struct option){0};

    printed_or_failed(argv[0]);
    opterr = 0;
    int found;
    while ((found = getopt_long(argc, argv, shorts, longs, NULL)) != -1) {
        if (found == 'h' || found == 256 + count) {
            print_help(argv[0], options, usage);
            exit(EXIT_DONE);
        }
        if (found == ':' || found == '?') {
            bool is_short = optopt != 0 && optopt < 256; // below 0: no ASCII
            Text word = is_short ? word_text((char[]){'-', (char)optopt, '\0'})
                                 : word_text(argv[optind - 1]);
            options_wrong(argv[0],
                          found == ':' ? "%s: a value is missing"
                                       : "'%s' is not an option, or takes no value",
                          word.s);
        }
        const Option *o = options;
        while (o->letter != found && 256 + (int)(o - options) != found)
            o++;
        out_of_range = NULL;
        bool is_read = o->read(optarg, o->into);
        if (out_of_range != NULL)
            options_wrong(argv[0], "--%s: '%s' %s", o->name, word_text(optarg).s, out_of_range);
        if (!is_read)
            options_wrong(argv[0], "--%s: '%s', expected %s%s%s", o->name, word_text(optarg).s,
                          o->expected, o->help != NULL ? ": " : "", o->help != NULL ? o->help : "");
    }
    return optind;
}
