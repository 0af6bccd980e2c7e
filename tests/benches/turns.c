// turns.c - how long whole programs take, in turns: beside the first one.
//
// Usage: turns ROUNDS [-- NAME PROGRAM ARGUMENT...]...
//
// If an argument ends with %, the program gets 1 thread, then 2: % becomes their number. Each ratio
// is taken in a round, to the first program's time with as many threads.
#include "tests/benches/turns.h"
#include "common/clock.h"
#include "common/progress.h"
#include "tests/benches/quantile.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MOST_PROGRAMS = 8, MOST_WORDS = 30, MOST_THREADS = 2 };

typedef struct {
    const char *name;
    char *words[MOST_WORDS + 1]; // the last one is NULL
    int threads;                 // 0: it is not told how many
    char number[10];             // the word that says how many
    double ms[MOST_ROUNDS];
} Program;

static Program programs[MOST_PROGRAMS * MOST_THREADS];
static int count;

// The words are up to "--" or NULL. True if it gets a number of threads.
static bool add(char **words, int threads)
{
    Program *program = &programs[count++];
    *program = (Program){.name = words[0]};
    words++;
    for (int i = 0; words[i] != NULL && strcmp(words[i], "--") != 0 && i < MOST_WORDS; i++) {
        size_t length = strlen(words[i]);
        program->words[i] = words[i];
        if (length == 0 || length >= sizeof program->number || words[i][length - 1] != '%')
            continue;
        program->threads = threads;
        program->words[i] = program->number;
        snprintf(program->number, sizeof program->number, "%.*s%d", (int)length - 1, words[i],
                 threads);
    }
    return program->threads > 0;
}

// Milliseconds.
static double run(const Program *program)
{
    int ends[2], status;
    double began = clock_seconds(), not_counted = 0;
    pid_t child = pipe(ends) == 0 ? fork() : -1;
    if (child == 0) {
        int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
        dup2(ends[1], NOT_COUNTED);
        execvp(program->words[0], program->words);
        _exit(1);
    }
    if (child < 0 || waitpid(child, &status, 0) != child || status != 0) {
        fprintf(stderr, "turns: %s fails\n", program->name);
        exit(1);
    }
    double took = clock_seconds() - began;
    close(ends[1]);
    if (read(ends[0], &not_counted, sizeof not_counted) != sizeof not_counted)
        not_counted = 0;
    close(ends[0]);
    return 1e3 * (took - not_counted);
}

static void report(const Program *program, int rounds)
{
    const Program *first = programs;
    while (first->threads != program->threads && first->threads != 0)
        first++;
    double times[MOST_ROUNDS];
    for (int i = 0; i < rounds; i++)
        times[i] = program->ms[i] / first->ms[i];
    const double *ms = program->ms, ratio = quantile(times, rounds, 0.5);
    char threads[2] = {program->threads > 0 ? (char)('0' + program->threads) : '-', '\0'};
    printf("  %-12s %7s %9.4g %9.4g %9.4g %9.4g  ", program->name, threads, quantile(ms, rounds, 0),
           quantile(ms, rounds, 0.25), quantile(ms, rounds, 0.5), quantile(ms, rounds, 0.75));
    if (program == first)
        printf("\n");
    else if (ratio >= 1)
        printf(" %.3g times %s\n", ratio, first->name);
    else
        printf(" %.3g times sooner than %s\n", 1 / ratio, first->name);
}

int main(int argc, char **argv)
{
    int rounds = argc > 1 ? atoi(argv[1]) : 0;
    for (int i = 2; i + 2 < argc && count + MOST_THREADS <= MOST_PROGRAMS * MOST_THREADS; i++)
        if (strcmp(argv[i], "--") == 0)
            for (int threads = 1; threads <= MOST_THREADS && add(argv + i + 1, threads);)
                threads++;
    if (rounds < 1 || rounds > MOST_ROUNDS || count == 0) {
        fprintf(stderr, "Usage: turns ROUNDS [-- NAME PROGRAM ARGUMENT...]...\n");
        return 2;
    }
    Progress progress = progress_begin("turns", (long)rounds * count, false);
    for (int round = 0; round < rounds; round++)
        for (int i = 0; i < count; i++) {
            programs[i].ms[round] = run(&programs[i]);
            progress_show(&progress, (long)round * count + i + 1);
        }
    progress_end(&progress);
    printf("  %-12s %7s %9s %9s %9s %9s   %s\n", "program", "threads", "least ms", "quartile",
           "median", "quartile", "median of ratios");
    for (int i = 0; i < count; i++)
        report(&programs[i], rounds);
    return 0;
}
