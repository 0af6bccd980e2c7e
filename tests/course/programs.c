// programs.c - runs programs, and ends them when this one is ended.
#include "tests/course/course.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

static volatile pid_t running; // what was started, or 0
static const int ends[] = {SIGINT, SIGTERM, SIGHUP};

static volatile sig_atomic_t interrupt_is_usual;

static void end_all(int number)
{
    if (running > 0)
        kill(running, SIGTERM);
    if (number == SIGINT && interrupt_is_usual) {
        // make gets this signal too, and says 'wait: No child processes' if we end before that.
        poll(NULL, 0, 300);
        _exit(0);
    }
    signal(number, SIG_DFL);
    raise(number);
}

void programs_end_with_us(void)
{
    struct sigaction action = {.sa_handler = end_all};
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
        struct sigaction old;
        sigaction(ends[i], NULL, &old);
        if (old.sa_handler != SIG_IGN) // nohup
            sigaction(ends[i], &action, NULL);
    }
}

void programs_end_as_usual_by_interrupt(void)
{
    interrupt_is_usual = 1;
}

// With V=1, as make shows its commands.
static void show_command(char *const *words, const char *output)
{
    const char *wanted = getenv("V");
    if (wanted == NULL || wanted[0] == '\0')
        return;
    for (int i = 0; words[i] != NULL; i++)
        printf("%s%s", i > 0 ? " " : "", words[i]);
    if (output != NULL)
        printf(" >%s 2>&1", output);
    putchar('\n');
}

// In the child: the input from /dev/null, the output and the errors into a file.
static _Noreturn void become(char *const *words, const char *output)
{
    int in = open("/dev/null", O_RDONLY | O_CLOEXEC), out = STDOUT_FILENO;
    if (output != NULL)
        out = open(output, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666);
    if (in >= 0 && out >= 0 && dup2(in, STDIN_FILENO) >= 0 && dup2(out, STDOUT_FILENO) >= 0 &&
        (output == NULL || dup2(out, STDERR_FILENO) >= 0))
        execvp(words[0], words);
    fprintf(stderr, "%s: %s\n", words[0], strerror(errno));
    _exit(127);
}

int program_run(char *const *words, const char *output, int seconds)
{
    sigset_t all, before;
    int status = 127 << 8;
    show_command(words, output);
    fflush(NULL);
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, &before); // no end between the fork and its being known
    pid_t parent = getpid(), pid = fork();
    if (pid > 0)
        running = pid;
    sigprocmask(SIG_SETMASK, &before, NULL);
    if (pid == 0) {
#ifdef __linux__
        prctl(PR_SET_PDEATHSIG, SIGTERM); // also when this program is killed
#endif
        const struct rlimit limit = {(rlim_t)seconds, (rlim_t)seconds};
        if (seconds > 0)
            setrlimit(RLIMIT_CPU, &limit);
        if (getppid() == parent)
            become(words, output);
        _exit(127);
    }
    while (pid > 0 && waitpid(pid, &status, 0) < 0 && errno == EINTR)
        continue;
    running = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

bool program_is_there(const char *name)
{
    const char *paths = getenv("PATH");
    for (const char *path = paths != NULL ? paths : ""; *path != '\0'; path += *path == ':') {
        char whole[4096];
        int length = (int)strcspn(path, ":");
        if (snprintf(whole, sizeof whole, "%.*s/%s", length, path, name) < (int)sizeof whole &&
            access(whole, X_OK) == 0)
            return true;
        path += length;
    }
    return false;
}
