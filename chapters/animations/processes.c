// processes.c - processes that run beside each other, and whole files.
#include "chapters/animations/processes.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

static pid_t running[MOST_RUNNING];
static volatile sig_atomic_t told_to_end;

__attribute__((format(printf, 1, 2))) Path path_of(const char *format, ...)
{
    Path path;
    va_list list;
    va_start(list, format);
    vsnprintf(path.s, sizeof path.s, format, list);
    va_end(list);
    return path;
}

__attribute__((format(printf, 1, 2), noreturn)) void fail(const char *format, ...)
{
    va_list list;
    va_start(list, format);
    vfprintf(stderr, format, list);
    va_end(list);
    exit(1);
}

// ---- files ------------------------------------------------------------------------------------

bool is_newer(Path path, Path other)
{
    struct stat a, b;
    if (stat(path.s, &a) != 0 || stat(other.s, &b) != 0)
        return false;
    return a.st_mtim.tv_sec != b.st_mtim.tv_sec ? a.st_mtim.tv_sec > b.st_mtim.tv_sec
                                                : a.st_mtim.tv_nsec > b.st_mtim.tv_nsec;
}

bool is_same(Path one, Path other)
{
    FILE *a = fopen(one.s, "r"), *b = fopen(other.s, "r");
    bool same = a != NULL && b != NULL;
    for (int c = 0; same && c != EOF;)
        same = (c = getc(a)) == getc(b);
    if (a != NULL)
        fclose(a);
    if (b != NULL)
        fclose(b);
    return same;
}

void copy(Path from, Path to)
{
    Path new = path_of("%s.new", to.s);
    FILE *in = fopen(from.s, "r"), *out = fopen(new.s, "w");
    if (in == NULL || out == NULL)
        fail("%s cannot be copied to %s: %s\n", from.s, to.s, strerror(errno));
    for (int c; (c = getc(in)) != EOF;)
        putc(c, out);
    fclose(in);
    if (fclose(out) != 0 || rename(new.s, to.s) != 0)
        fail("%s cannot be written: %s\n", to.s, strerror(errno));
}

void make_folder(Path path)
{
    if (mkdir(path.s, 0777) != 0 && errno != EEXIST)
        fail("%s cannot be made: %s\n", path.s, strerror(errno));
}

void remove_from(const char *in, const char *format, int number)
{
    char name[40];
    do
        snprintf(name, sizeof name, format, number++);
    while (remove(path_of("%s/%s", in, name).s) == 0);
}

// ---- processes --------------------------------------------------------------------------------

void end_all(void)
{
    for (int i = 0; i < MOST_RUNNING; i++)
        if (running[i] > 0)
            kill(running[i], SIGTERM);
    while (waitpid(-1, NULL, 0) > 0 || errno == EINTR)
        ;
    exit(1);
}

static void note_end(int signal_number)
{
    (void)signal_number;
    told_to_end = 1;
}

void end_with_processes(void)
{
    struct sigaction action = {.sa_handler = note_end};
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    sigaction(SIGHUP, &action, NULL);
}

bool is_free(int place)
{
    return running[place] == 0;
}

void start(int place, char *const arguments[], Path said)
{
    pid_t process = fork();
    if (process < 0)
        fail("a process cannot be started: %s\n", strerror(errno));
    if (process > 0) {
        running[place] = process;
        return;
    }
    int in = open("/dev/null", O_RDONLY);
    int out = open(said.s, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    dup2(in, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(out, STDERR_FILENO);
    execvp(arguments[0], arguments);
    _exit(127);
}

int wait_for_one(bool *succeeded)
{
    for (;;) {
        int status;
        pid_t process = waitpid(-1, &status, 0);
        if (told_to_end)
            end_all();
        for (int i = 0; i < MOST_RUNNING && process > 0; i++)
            if (running[i] == process) {
                running[i] = 0;
                *succeeded = WIFEXITED(status) && WEXITSTATUS(status) == 0;
                return i;
            }
    }
}

bool run(char *const arguments[], Path said)
{
    bool succeeded;
    start(0, arguments, said);
    wait_for_one(&succeeded);
    return succeeded;
}

void show(Path said)
{
    FILE *file = fopen(said.s, "r");
    for (int c; file != NULL && (c = getc(file)) != EOF;)
        fputc(c, stderr);
    if (file != NULL)
        fclose(file);
    remove(said.s);
}

bool has_program(const char *name)
{
    char all[4096];
    snprintf(all, sizeof all, "%s", getenv("PATH") != NULL ? getenv("PATH") : "");
    for (char *in = strtok(all, ":"); in != NULL; in = strtok(NULL, ":"))
        if (access(path_of("%s/%s", in, name).s, X_OK) == 0)
            return true;
    return false;
}
