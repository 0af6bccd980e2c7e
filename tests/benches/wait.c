// wait.c - what the user waits for: whole processes, beside only reading a scene and only writing
// its picture, which is the least that it could be.
//
// Usage: wait SCENE.nff FILE.png WIDTH HEIGHT ROUNDS [-- NAME PROGRAM ARGUMENT...]...
//        wait alone SCENE.nff FILE.png WIDTH HEIGHT THREADS
//
// Each program gets 1 thread, then 2: in its arguments % is their number. All take turns, and each
// ratio is taken in a round, to the first one's time. 'alone' is this program: it reads and writes
// FILE.png, and between them casts the picture. It says how long it casts, which is not counted.
#include "chapters/08-fast/engines/engine.h"
#include "chapters/08-fast/engines/parallel.h"
#include "chapters/shared/scene_camera.h"
#include "common/clock.h"
#include "common/workers.h"
#include "tests/benches/quantile.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MOST_PROGRAMS = 8, MOST_THREADS = 2 };

typedef struct {
    const char *name;
    char **words; // up to "--" or NULL
    double ms[MOST_THREADS][MOST_ROUNDS];
} Program;

enum { PIPE = 3 }; // where 'alone' writes

static int alone(char **words)
{
    Scene scene;
    Image image;
    Message message = {"no camera"};
    Resolution size = {atoi(words[2]), atoi(words[3])};
    Work work = {.scene = &scene, .image = &image, .threads = atoi(words[4])};
    workers_are(in_parallel, work.threads);
    bool done = scene_load(words[0], &scene, &message) &&
                scene_camera(&scene.view, size, &work.camera) == CAMERA_OK &&
                image_create(&image, size, &message);
    double began = clock_seconds();
    done = done && cast_bins(&work, &message);
    double seconds = clock_seconds() - began;
    done = done && image_write_png(&image, words[1], &message) &&
           write(PIPE, &seconds, sizeof seconds) == sizeof seconds;
    if (!done)
        fprintf(stderr, "%s\n", message.text);
    return done ? 0 : 1;
}

// The words are the process's own. Numbers of threads have one digit.
static void become(char **words, int threads, int pipe)
{
    int count = 0;
    for (; words[count] != NULL && strcmp(words[count], "--") != 0; count++) {
        char *mark = strchr(words[count], '%');
        if (mark != NULL)
            *mark = (char)('0' + threads);
    }
    words[count] = NULL;
    int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    dup2(pipe, PIPE);
    execvp(words[0], words);
}

// Milliseconds.
static double run(const Program *program, int threads)
{
    int ends[2], status;
    double began = clock_seconds(), seconds = 0;
    pid_t child = pipe(ends) == 0 ? fork() : -1;
    if (child == 0) {
        become(program->words, threads, ends[1]);
        _exit(1);
    }
    if (child < 0 || waitpid(child, &status, 0) != child || status != 0) {
        fprintf(stderr, "wait: %s fails\n", program->name);
        exit(1);
    }
    double took = clock_seconds() - began;
    close(ends[1]);
    if (read(ends[0], &seconds, sizeof seconds) != sizeof seconds)
        seconds = 0;
    close(ends[0]);
    return 1e3 * (took - seconds);
}

static void report(const Program *program, const double *alone, int threads, int rounds)
{
    const double *ms = program->ms[threads - 1];
    double times[MOST_ROUNDS];
    for (int i = 0; i < rounds; i++)
        times[i] = ms[i] / alone[i];
    printf("  %-12s %7d %9.4g %9.4g %9.4g %9.4g   %.3g\n", program->name, threads,
           quantile(ms, rounds, 0), quantile(ms, rounds, 0.25), quantile(ms, rounds, 0.5),
           quantile(ms, rounds, 0.75), quantile(times, rounds, 0.5));
}

int main(int argc, char **argv)
{
    if (argc == 7 && strcmp(argv[1], "alone") == 0)
        return alone(argv + 2);
    char *words[] = {argv[0], "alone", argv[1], argv[2], argv[3], argv[4], (char[]){"%"}, NULL};
    Program programs[MOST_PROGRAMS] = {{.name = "alone", .words = words}};
    int count = 1, rounds = argc > 5 ? atoi(argv[5]) : 0;
    for (int i = 6; i + 2 < argc && count < MOST_PROGRAMS; i++)
        if (strcmp(argv[i], "--") == 0)
            programs[count++] = (Program){.name = argv[i + 1], .words = argv + i + 2};
    if (rounds < 1 || rounds > MOST_ROUNDS) {
        fprintf(stderr, "Usage: wait SCENE.nff FILE.png WIDTH HEIGHT ROUNDS [-- NAME PROGRAM "
                        "ARGUMENT...]...\n");
        return 2;
    }
    for (int round = 0; round < rounds; round++)
        for (int threads = 1; threads <= MOST_THREADS; threads++)
            for (int i = 0; i < count; i++)
                programs[i].ms[threads - 1][round] = run(&programs[i], threads);
    printf("%s to picture, %sx%s, %d rounds in turns\n"
           "  %-12s %7s %9s %9s %9s %9s   %s\n",
           argv[1], argv[3], argv[4], rounds, "program", "threads", "least ms", "quartile",
           "median", "quartile", "times alone (median of ratios)");
    for (int threads = 1; threads <= MOST_THREADS; threads++)
        for (int i = 0; i < count; i++)
            report(&programs[i], programs[0].ms[threads - 1], threads, rounds);
    return 0;
}
