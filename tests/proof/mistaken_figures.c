// mistaken_figures.c - a figure with every known mistake in the place of a right answer, as 'make
// figures ANSWERS=folder' draws it. Linked with the program of a chapter.
//
//   mistaken_figures FIGURE FOLDER EVERY FIRST [OPTION...]
//
// Of all mistakes of the functions that the figure calls it takes number FIRST and each EVERY-th
// after it. It writes FOLDER/FIGURE-N.gp, once for mistakes that look the same, and prints a line
// for each: the file, and the mistake.
#include "tests/judge/known.h"
#include "tests/judge/reference/proxies.h"
#include "tests/judge/stem.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MOST_SCRIPTS = 2000, MOST_OPTIONS = 40 };

// The program's own main: this one is called in its place (-Wl,--wrap=main).
int __real_main(int argc, char **argv);
int __wrap_main(int argc, char **argv);

static const char *folder, *figure;
static char **options;
static int option_count;
static unsigned long seen[MOST_SCRIPTS];
static int seen_count;

static bool was_seen(const char *path)
{
    unsigned long sum = 14695981039346656037u;
    FILE *file = fopen(path, "r");
    for (int c; file != NULL && (c = getc(file)) != EOF;)
        sum = (sum ^ (unsigned long)c) * 1099511628211u;
    if (file != NULL)
        fclose(file);
    for (int i = 0; i < seen_count; i++)
        if (seen[i] == sum)
            return true;
    seen[seen_count++] = sum;
    return seen_count == MOST_SCRIPTS;
}

// What the program prints for the figure, in a process of its own: it may crash.
static bool print_figure(const char *path, char **more)
{
    char *arguments[MOST_OPTIONS] = {"figure", "--figure", (char *)figure};
    int count = 3;
    for (int i = 0; i < option_count; i++)
        arguments[count++] = options[i];
    for (; *more != NULL; more++)
        arguments[count++] = *more;
    fflush(stdout);
    pid_t process = fork();
    if (process == 0) {
        if (freopen(path, "w", stdout) == NULL)
            _exit(1);
        int status = __real_main(count, arguments);
        fflush(stdout);
        _exit(status);
    }
    int status;
    if (process < 0 || waitpid(process, &status, 0) != process)
        return false;
    if (WIFSIGNALED(status))
        fprintf(stderr, "%s: crashed by signal %d\n", path, WTERMSIG(status));
    return status == 0;
}

// Whether the figure calls a function of this stem; which function of the same stem that calls is
// not known.
static bool is_called(const char *answers, const char *stem)
{
    char name[100];
    bool found = false;
    FILE *file = fopen(answers, "r");
    while (file != NULL && !found && fscanf(file, "%99s", name) == 1)
        found = strcmp(exercises[exercise_number(name)].stem, stem) == 0;
    if (file != NULL)
        fclose(file);
    return found;
}

// As the judge names it below the figure.
static void draw(const Mistake *mistake, int number, char *right)
{
    char path[4096], note[2000];
    snprintf(path, sizeof path, "%s/%s-%d.gp", folder, figure, number);
    snprintf(note, sizeof note, "%s looks like %s: %s", mistake->exercise, mistake->formula,
             mistake->why);
    int exercise = exercise_number(mistake->exercise);
    answer_by(exercise, mistake->answer);
    bool printed = print_figure(path, (char *[]){"--beside", right, NULL});
    if (printed && was_seen(path))
        unlink(path);
    else if (printed && print_figure(path, (char *[]){"--beside", right, "--note", note, NULL}))
        printf("%s\t%s %s\n", path, mistake->exercise, mistake->id);
    else
        unlink(path); // it has said why
    answer_by(exercise, exercises[exercise].reference);
}

int __wrap_main(int argc, char **argv)
{
    if (argc < 5 || argc > MOST_OPTIONS - 10) {
        fprintf(stderr, "Usage: %s FIGURE FOLDER EVERY FIRST [OPTION...]\n", argv[0]);
        return 2;
    }
    figure = argv[1];
    folder = argv[2];
    int every = atoi(argv[3]), first = atoi(argv[4]), number = 0;
    options = argv + 5;
    option_count = argc - 5;
    char answers[4096], right[4096], *none[] = {NULL};
    snprintf(answers, sizeof answers, "%s/%s.answers", folder, figure);
    snprintf(right, sizeof right, "%s/%s.gp", folder, figure);
    if (!print_figure(right, none) || !print_figure(answers, (char *[]){"--answers", NULL}))
        return 1;
    for (int i = 0; exercises[i].name != NULL; i++) {
        if ((i > 0 && strcmp(exercises[i].stem, exercises[i - 1].stem) == 0) ||
            !is_called(answers, exercises[i].stem))
            continue;
        choose_stem(exercises[i].stem);
        for (const Mistake *it = known_answers(WRONG_ANSWERS); it != NULL; it = it->next)
            if (number++ % every == first)
                draw(it, number, right);
    }
    return 0;
}
