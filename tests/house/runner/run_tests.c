// run_tests.c - runs test programs, as many at a time as there are processors, and adds up what
// they say.
//
//   run_tests LOG-FOLDER PROGRAM...
//
// A program may be followed by an argument, after a blank: 'build/tests/matrix 05-quadratic'.
//
// The last line of a test is 'NAME: N passed, N failed'. A test that ends without it, or exits
// non-zero though nothing failed, counts as one failure, and all that it printed is shown. Of a
// test that passes some lines are shown: '+ words'; '+ N things' as a sum over all tests, at the
// end; and 'skipped: what, and why', also at the end. LOG-FOLDER keeps everything, and in 'seconds'
// the seconds that each test took: of a processor, which is nearly the same on a busy machine, and
// by the clock.
//
// Scripts (.sh) may build in the tree, so they take turns. Programs run beside them, and so do
// scripts that say in a line of their own '# Only reads the tree.' or '# Builds only below its
// answers.': the build of a folder of answers that nobody else has. Those that took longest in the
// last run begin first: at the end no processor waits.
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { MOST_THINGS = 100, WORTH_TELLING = 20 /* seconds */ };

typedef struct {
    const char *program;
    char name[256];
    FILE *log;
    bool takes_turns;
    double expected; // seconds of a processor
    pid_t process;   // 0: not begun; -1: ended
    time_t began;
    int seconds;
    double of_processor;
} Test;

// The sums over all tests: a number for each wording.
typedef struct {
    char words[200];
    long number;
} Thing;

static Thing things[MOST_THINGS];
static char *skipped[1000];
static int thing_count, skipped_count;
static long passed, failed;
static Test *tests;
static int count;

static bool is_script(const char *program)
{
    size_t length = strlen(program);
    return length >= 3 && strcmp(program + length - 3, ".sh") == 0;
}

static bool takes_turns(const char *program)
{
    if (!is_script(program))
        return false;
    FILE *script = fopen(program, "r");
    char line[1000];
    bool alone = true;
    while (script != NULL && alone && fgets(line, sizeof line, script) != NULL)
        alone = strcmp(line, "# Only reads the tree.\n") != 0 &&
                strcmp(line, "# Builds only below its answers.\n") != 0;
    if (script != NULL)
        fclose(script);
    return alone;
}

// Its output goes into a file without a name: nothing in the tree changes while tests run.
static void set_test(Test *test, const char *program)
{
    *test = (Test){.program = program,
                   .takes_turns = takes_turns(program),
                   .expected = is_script(program) ? 10 : 1, // unless the last run knows better
                   .log = tmpfile()};
    if (test->log == NULL) {
        perror("no temporary file for what a test says");
        exit(2);
    }
    fcntl(fileno(test->log), F_SETFD, FD_CLOEXEC);
    snprintf(test->name, sizeof test->name, "%s", program);
    for (char *c = test->name; *c != '\0'; c++)
        if (*c == '/' || *c == ' ')
            *c = '_';
}

// How long each took when all of them ran last.
static void expect_seconds(const char *folder)
{
    char path[4096], line[4096], program[4096];
    snprintf(path, sizeof path, "%s/seconds", folder);
    FILE *kept = fopen(path, "r");
    double taken;
    while (kept != NULL && fgets(line, sizeof line, kept) != NULL)
        if (sscanf(line, "%lf %*d %4095[^\n]", &taken, program) == 2)
            for (int i = 0; i < count; i++)
                if (strcmp(tests[i].program, program) == 0)
                    tests[i].expected = taken;
    if (kept != NULL)
        fclose(kept);
}

// ---- running ------------------------------------------------------------------------------------

// Each test is a process group, which ends as a whole if this program gets a signal to end.
static void stop(int signal_number)
{
    for (int i = 0; i < count; i++)
        if (tests[i].process > 0)
            kill(-tests[i].process, SIGTERM);
    _exit(128 + signal_number);
}

static _Noreturn void run(const char *words)
{
    char *program = strdup(words), *argument = program != NULL ? strchr(program, ' ') : NULL;
    if (argument != NULL)
        *argument++ = '\0';
    execl(program, program, argument, (char *)NULL);
    perror(words);
    _exit(127);
}

static void begin(Test *test)
{
    test->began = time(NULL);
    test->process = fork();
    if (test->process < 0) {
        perror("a test cannot be started");
        stop(0);
    }
    if (test->process == 0) {
        setpgid(0, 0);
        dup2(fileno(test->log), STDOUT_FILENO);
        dup2(fileno(test->log), STDERR_FILENO);
        run(test->program);
    }
    setpgid(test->process, test->process);
}

// The next test that may begin now: those that take turns begin first, because they take longest
// together.
static Test *next(void)
{
    bool turn_is_taken = false;
    for (int i = 0; i < count; i++)
        turn_is_taken = turn_is_taken || (tests[i].takes_turns && tests[i].process > 0);
    Test *best = NULL;
    for (int i = 0; i < count; i++) {
        Test *test = &tests[i];
        if (test->process != 0 || (test->takes_turns && turn_is_taken))
            continue;
        if (best == NULL || test->takes_turns > best->takes_turns ||
            (test->takes_turns == best->takes_turns && test->expected > best->expected))
            best = test;
    }
    return best;
}

// ---- what they say ------------------------------------------------------------------------------

static void add_thing(long number, const char *words)
{
    int i = 0;
    while (i < thing_count && strcmp(things[i].words, words) != 0)
        i++;
    if (i == MOST_THINGS)
        return;
    if (i == thing_count)
        snprintf(things[thing_count++].words, sizeof things[i].words, "%s", words);
    things[i].number += number;
}

static void add_skipped(const char *what)
{
    for (int i = 0; i < skipped_count; i++)
        if (strcmp(skipped[i], what) == 0)
            return;
    if (skipped_count < (int)(sizeof skipped / sizeof skipped[0]))
        skipped[skipped_count++] = strdup(what);
}

static void listen_to(char *line)
{
    char *words;
    if (strncmp(line, "skipped:", 8) == 0) {
        for (line += 8; *line == ' '; line++)
            ;
        add_skipped(line);
    } else if (strncmp(line, "+ ", 2) == 0) {
        long number = strtol(line + 2, &words, 10);
        if (words > line + 2 && *words == ' ')
            add_thing(number, words + 1);
        else
            printf("%s\n", line + 2);
    }
}

// Is it 'NAME: N passed, N failed'?
static bool is_sum(const char *line, long *p, long *f)
{
    int end = 0;
    for (const char *colon = strchr(line, ':'); colon != NULL; colon = strchr(colon + 1, ':'))
        if (sscanf(colon, ": %ld passed, %ld failed%n", p, f, &end) == 2 && end > 0 &&
            colon[end] == '\0')
            return true;
    return false;
}

static void hear(const Test *test, int status)
{
    char *line = NULL, *last = strdup("");
    size_t size = 0;
    rewind(test->log);
    while (getline(&line, &size, test->log) > 0) {
        line[strcspn(line, "\n")] = '\0';
        listen_to(line);
        free(last);
        last = strdup(line);
    }
    long p = 0, f = 0;
    bool ended_well = is_sum(last, &p, &f) && (status == 0 || f > 0);
    if (!ended_well) {
        p = 0;
        f = 1;
    }
    if (f > 0) {
        rewind(test->log);
        while (getline(&line, &size, test->log) > 0)
            printf("    %s%s", line, strchr(line, '\n') == NULL ? "\n" : "");
    }
    if (ended_well)
        printf("%s", last);
    else if (WIFSIGNALED(status))
        printf("%s: ended by signal %d", test->program, WTERMSIG(status));
    else
        printf("%s: ended with exit status %d", test->program, WEXITSTATUS(status));
    if (test->seconds >= WORTH_TELLING)
        printf("   (%d s)", test->seconds);
    printf("\n");
    fflush(stdout);
    passed += p;
    failed += f;
    free(line);
    free(last);
}

static Test *test_of(pid_t process)
{
    for (int i = 0; i < count; i++)
        if (tests[i].process == process)
            return &tests[i];
    return NULL;
}

static void show_progress(int ended)
{
    if (!isatty(STDERR_FILENO))
        return;
    fprintf(stderr, "\r  tests     %d of %d\033[K", ended, count);
    if (ended == count)
        fprintf(stderr, "\r\033[K");
}

static double seconds_of(struct timeval time)
{
    return (double)time.tv_sec + (double)time.tv_usec / 1e6;
}

static void run_all(int at_a_time)
{
    int running = 0, ended = 0;
    while (ended < count) {
        for (Test *test; running < at_a_time && (test = next()) != NULL; running++)
            begin(test);
        show_progress(ended);
        int status;
        struct rusage used;
        pid_t process = wait4(-1, &status, 0, &used);
        Test *test = process < 0 ? NULL : test_of(process);
        if (process < 0 && errno != EINTR)
            break;
        if (test == NULL)
            continue;
        test->process = -1;
        test->seconds = (int)(time(NULL) - test->began);
        test->of_processor = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
        running--;
        ended++;
        if (isatty(STDERR_FILENO))
            fprintf(stderr, "\r\033[K");
        hear(test, status);
    }
    show_progress(count);
}

// ---- the end ------------------------------------------------------------------------------------

static void keep_logs(const char *folder)
{
    for (int i = 0; i < count; i++) {
        char path[4096], piece[4096];
        snprintf(path, sizeof path, "%s/%s", folder, tests[i].name);
        FILE *kept = fopen(path, "w");
        rewind(tests[i].log);
        for (size_t n; kept != NULL && (n = fread(piece, 1, sizeof piece, tests[i].log)) > 0;)
            fwrite(piece, 1, n, kept);
        if (kept == NULL || fclose(kept) != 0)
            perror(path);
    }
}

static void keep_seconds(const char *folder)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/seconds", folder);
    FILE *kept = fopen(path, "w");
    for (int i = 0; kept != NULL && i < count; i++)
        fprintf(kept, "%.2f %d %s\n", tests[i].of_processor, tests[i].seconds, tests[i].program);
    if (kept == NULL || fclose(kept) != 0)
        perror(path);
}

static void report(void)
{
    for (int i = 0; i < thing_count; i++)
        printf("%s%ld %s%s", i == 0 ? "In all: " : "", things[i].number, things[i].words,
               i + 1 == thing_count ? "\n" : ", ");
    if (skipped_count > 0)
        printf("Not tested here:\n");
    for (int i = 0; i < skipped_count; i++)
        printf("  %s\n", skipped[i]);
    printf("%ld passed, %ld failed\n", passed, failed);
}

static int processors(void)
{
    long online = sysconf(_SC_NPROCESSORS_ONLN);
    return online < 2 ? 2 : online > 64 ? 64 : (int)online;
}

int main(int argc, char **argv)
{
    if (argc < 3) {
        fprintf(stderr, "Usage: %s LOG-FOLDER PROGRAM...\n", argv[0]);
        return 2;
    }
    if (mkdir(argv[1], 0777) != 0 && errno != EEXIST) {
        perror(argv[1]);
        return 2;
    }
    count = argc - 2;
    tests = calloc((size_t)count, sizeof *tests);
    if (tests == NULL) {
        perror("tests");
        return 2;
    }
    for (int i = 0; i < count; i++)
        set_test(&tests[i], argv[i + 2]);
    expect_seconds(argv[1]);
    struct sigaction action = {.sa_handler = stop};
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    sigaction(SIGHUP, &action, NULL);
    run_all(processors());
    keep_logs(argv[1]);
    keep_seconds(argv[1]);
    report();
    return failed > 0 || passed == 0;
}
