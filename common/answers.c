// answers.c - which blanks were called, and which answers.
#include "common/answers.h"

#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// As many as anybody calls in one run; what is beyond is left out, not lost: it shows next time.
enum { MOST = 64 };

static struct {
    const char *function, *file;
} missing[MOST];
static int missing_count;

void *not_answered(const char *function, const char *file, void *value, size_t size)
{
    if (value != NULL)
        memset(value, 0xff, size);
    for (int i = 0; i < missing_count; i++)
        if (strcmp(missing[i].function, function) == 0)
            return value;
    if (missing_count < MOST) {
        missing[missing_count].function = function;
        missing[missing_count++].file = file;
    }
    return value;
}

int answers_missing(void)
{
    return missing_count;
}

const char *answer_missing(int i)
{
    return missing[i].function;
}

void answers_forget(void)
{
    missing_count = 0;
}

static const char *called[MOST];
static atomic_int called_count;

void answer_called(const char *function)
{
    int i = atomic_fetch_add(&called_count, 1);
    if (i < MOST)
        called[i] = function;
}

int answers_called(void)
{
    int count = atomic_load(&called_count);
    return count < MOST ? count : MOST;
}

const char *answer_that_was_called(int i)
{
    return called[i];
}

// Make goes on with the pictures that can be drawn.
static void end_without(const char *picture)
{
    fprintf(stderr, "  %-9s %s: needs %s", "not yet", picture, missing[0].function);
    if (missing_count > 1)
        fprintf(stderr, " (and %d more)", missing_count - 1);
    fputs("\n", stderr);
    exit(EXIT_SUCCESS);
}

int answers_report(void)
{
    const char *picture = getenv("NOT_YET");
    if (missing_count > 0 && picture != NULL)
        end_without(picture);
    for (int i = 0; i < missing_count; i++)
        fprintf(stderr, "%s: not answered yet: %s\n", missing[i].file, missing[i].function);
    return missing_count > 0 ? 1 : 0;
}
