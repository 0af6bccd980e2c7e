// confine - starts a program that may do next to nothing, because what it holds is hostile.
//
//   confine answer PROGRAM                   a student's answers: memory, mathematics, and pipes
//                                            that are open already (3 in, 4 out; print to 1 and 2)
//   confine compile WRITABLE... - READABLE... -- PROGRAM ARGUMENT...
//                                            a compiler on a student's text: files in these places
//   confine judge WRITABLE... - READABLE... -- PROGRAM ARGUMENT...
//                                            the judge: files in these places
//   confine watch PARENT -- PROGRAM ARGUMENT...
//                                            not confined: nothing of it outlives it, or the
//                                            process PARENT that started this (watch.c)
//   confine tool PROGRAM ARGUMENT...         a part of the compiler; its exit status says how that
//                                            ended (watch.c), which no message of it can forge
//   confine room PROCESSES                   fails if that many processes cannot be started
//   confine probe                            says what this kernel has: 'landlock', 'seccomp'
//
// No capabilities, limits, then Landlock (files, network, signals), then seccomp (system calls);
// each alone would do for most attacks. The children of the program inherit the limits. Exit status
// 126: could not be confined.
#define _GNU_SOURCE
#include "tests/grade/confine/confine.h"
#include "tests/judge/process.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/capability.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

enum {
    PROGRAM = 9, // the descriptor of what is started
    MEGABYTE = 1 << 20,
    ANSWER_MEMORY = 512 * MEGABYTE,
    ANSWER_PRINTED = MEGABYTE,
    ANSWER_SECONDS = 120, // of work in all; the judge stops one call long before
    COMPILE_MEMORY = 1024 * MEGABYTE,
    COMPILE_FILE = 16 * MEGABYTE,
    COMPILE_SECONDS = 5,      // of work for each part of the compiler, and each file
    COMPILE_PROCESSES = 4096, // all processes of this user, if there is no user namespace
};

static bool judge_listens; // for why an answer was not started (tests/judge/process.h)

void give_up(const char *what)
{
    int error = errno;
    fprintf(stderr, "confine: %s: %s\n", what, strerror(error));
    if (judge_listens && write(START_ERROR, &error, sizeof error) < 0)
        exit(125);
    exit(126);
}

// option: of the shell's ulimit
static void limit(__rlimit_resource_t what, rlim_t most, char option)
{
    struct rlimit limits = {most, most};
    if (setrlimit(what, &limits) == 0)
        return;
    char words[80];
    snprintf(words, sizeof words, "the hard limit 'ulimit -%c' of this machine is too low", option);
    give_up(words);
}

// Shared machines allow fewer.
static void limit_processes(rlim_t most)
{
    struct rlimit limits;
    if (getrlimit(RLIMIT_NPROC, &limits) != 0)
        give_up("getrlimit");
    limit(RLIMIT_NPROC, limits.rlim_max < most ? limits.rlim_max : most, 'u');
}

// In a container without bubblewrap the grader is often root. Without new privileges a program that
// is started gets none of them back.
static void drop_capabilities(void)
{
    struct __user_cap_header_struct version = {_LINUX_CAPABILITY_VERSION_3, 0};
    struct __user_cap_data_struct none[_LINUX_CAPABILITY_U32S_3] = {0};
    if (syscall(SYS_capset, &version, none) != 0)
        give_up("to drop capabilities");
}

static void start_answers(const char *program)
{
    judge_listens = fcntl(START_ERROR, F_SETFD, FD_CLOEXEC) == 0;
    int file = open(program, O_RDONLY | O_CLOEXEC);
    if (file < 0 || dup3(file, PROGRAM, O_CLOEXEC) != PROGRAM)
        give_up(program);
    close(file);
    if (landlock_version() > 0) {
        int rules = landlock_begin();
        landlock_allow_program(rules, PROGRAM);
        landlock_end(rules);
    }
    limit(RLIMIT_CORE, 0, 'c');
    limit(RLIMIT_FSIZE, ANSWER_PRINTED, 'f');
    limit(RLIMIT_AS, ANSWER_MEMORY, 'v');
    limit(RLIMIT_CPU, ANSWER_SECONDS, 't');
    limit(RLIMIT_NPROC, 1, 'u');
    limit(RLIMIT_NOFILE, 5, 'n');
    // The same addresses and no clock, so that nothing differs between two runs.
    personality(ADDR_NO_RANDOMIZE);
#ifdef PR_SET_TSC
    prctl(PR_SET_TSC, PR_TSC_SIGSEGV, 0, 0, 0);
#endif
    allow_answers(PROGRAM);
    char *const arguments[] = {(char *)"answering", NULL}, *const environment[] = {NULL};
    syscall(SYS_execveat, PROGRAM, "", arguments, environment, AT_EMPTY_PATH);
    int error = errno;
    _exit(write(START_ERROR, &error, sizeof error) < 0 ? 126 : 127);
}

static void allow_places(char **places, char **command)
{
    if (landlock_version() > 0) {
        int rules = landlock_begin();
        void (*allow)(int, const char *) = landlock_allow_all;
        allow(rules, "/dev/null");
        for (char **place = places; place < command - 1; place++) {
            if (strcmp(*place, "-") == 0)
                allow = landlock_allow_read;
            else
                allow(rules, *place);
        }
        landlock_end(rules);
    }
    limit(RLIMIT_CORE, 0, 'c');
}

static void start_compiler(char **places, char **command)
{
    allow_places(places, command);
    limit(RLIMIT_FSIZE, COMPILE_FILE, 'f');
    limit(RLIMIT_AS, COMPILE_MEMORY, 'v');
    // At the lower one the signal says what it is for; SIGKILL would not.
    limit(RLIMIT_CPU, COMPILE_SECONDS + 1, 't');
    struct rlimit work = {COMPILE_SECONDS, COMPILE_SECONDS + 1};
    if (setrlimit(RLIMIT_CPU, &work) != 0)
        give_up("setrlimit");
    limit_processes(COMPILE_PROCESSES);
    limit(RLIMIT_NOFILE, 64, 'n');
    allow_compiler();
    execv(command[0], command);
    give_up(command[0]);
}

static int probe(void)
{
    if (landlock_version() > 0)
        printf("landlock\n");
    if (prctl(PR_GET_SECCOMP, 0, 0, 0, 0) >= 0)
        printf("seccomp\n");
    return 0;
}

int main(int argc, char **argv)
{
    const char *mode = argc > 1 ? argv[1] : "";
    if (argc == 2 && strcmp(mode, "probe") == 0)
        return probe();
    if (argc > 2 && strcmp(mode, "tool") == 0)
        return run_tool(argv + 2);
    if (argc == 3 && strcmp(mode, "room") == 0)
        return room_for(atoi(argv[2]));
    char **command = argv + (argc > 0 ? 1 : 0);
    while (*command != NULL && strcmp(*command, "--") != 0)
        command++;
    bool answer = argc == 3 && strcmp(mode, "answer") == 0;
    bool has_command = *command != NULL && command[1] != NULL;
    bool watched = strcmp(mode, "watch") == 0 && has_command && command == argv + 3;
    bool compile = argc > 4 && strcmp(mode, "compile") == 0 && has_command;
    bool judge = argc > 4 && strcmp(mode, "judge") == 0 && has_command;
    if (watched)
        watch(atoi(argv[2]), command + 1);
    if (!answer && !compile && !judge) {
        fprintf(stderr, "Usage: confine answer PROGRAM | compile | judge WRITABLE... - READABLE... "
                        "-- PROGRAM ARGUMENT... | watch PARENT -- PROGRAM ARGUMENT... | "
                        "tool PROGRAM ARGUMENT... | room PROCESSES | probe\n");
        return 2;
    }
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
        give_up("no new privileges");
    drop_capabilities();
    if (prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0) != 0)
        give_up("to end with its parent");
    if (answer)
        start_answers(argv[2]);
    if (compile)
        start_compiler(argv + 2, command + 1);
    allow_places(argv + 2, command + 1);
    execv(command[1], command + 1);
    give_up(command[1]);
}
