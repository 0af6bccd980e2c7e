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
//                                            process PARENT that started this
//   confine tool PROGRAM ARGUMENT...         a part of the compiler; its exit status says how that
//                                            ended, which no message of it can forge
//   confine room PROCESSES                   fails if that many processes cannot be started
//   confine probe                            says what this kernel has: 'landlock', 'seccomp'
//
// No capabilities, limits, then Landlock (files, network, signals), then seccomp (system calls);
// each alone would do for most attacks. The children of the program inherit the limits. Exit status
// 126: could not be confined.
#define _GNU_SOURCE
#include "tests/judge/process.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/capability.h>
#include <seccomp.h>
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/param.h>
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
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

// What cannot be confined is not started: says what failed, and errno's reason.
static _Noreturn void give_up(const char *what)
{
    int error = errno;
    fprintf(stderr, "confine: %s: %s\n", what, strerror(error));
    if (judge_listens && write(START_ERROR, &error, sizeof error) < 0)
        exit(125);
    exit(126);
}

// ---- Landlock -----------------------------------------------------------------------------------

// What of the file system, the network and other processes can be reached. By its system calls: the
// C library has no names for them, and older systems have no header (Debian 11 lacks it). The
// numbers are the kernel's, on every processor: https://docs.kernel.org/userspace-api/landlock.html
enum { CREATE_RULESET = 444, ADD_RULE, RESTRICT_SELF };
enum { ASK_VERSION = 1 };       // a flag of CREATE_RULESET
enum { RULE_PATH_BENEATH = 1 }; // a kind of rule
struct path_beneath {
    uint64_t rights;
    int32_t place; // an open folder or file
} __attribute__((packed));

// Newer kernels know more rights than the headers that this was compiled with.
struct rights {
    uint64_t files, network, scoped;
};
enum {
    WRITE_FILE = 1 << 1,
    EXECUTE = 1 << 0 | 1 << 2, // and to read the file
    READ = EXECUTE | 1 << 3,   // and to read the folder
    ALL_1 = (1 << 13) - 1,     // of version 1
    REFER = 1 << 13,           // 2
    TRUNCATE = 1 << 14,        // 3
    NETWORK = 3,               // 4: bind, connect
    IOCTL = 1 << 15,           // 5
    SCOPED = 3,                // 6: abstract sockets, signals
};

// The version of Landlock in this kernel; 0: none.
static int landlock_version(void)
{
    long version = syscall(CREATE_RULESET, NULL, 0, ASK_VERSION);
    return version < 0 ? 0 : (int)version;
}

static uint64_t all_rights(void)
{
    int version = landlock_version();
    return ALL_1 | (version >= 2 ? REFER : 0) | (version >= 3 ? TRUNCATE : 0) |
           (version >= 5 ? IOCTL : 0);
}

// A set of rules that allows nothing yet (a descriptor); what is allowed is added; then it holds
// for this process and all that it starts, for good. Rules that this system lacks are left out.
static int landlock_begin(void)
{
    int version = landlock_version();
    struct rights rights = {.files = all_rights()};
    if (version >= 4)
        rights.network = NETWORK;
    if (version >= 6)
        rights.scoped = SCOPED;
    size_t size = version >= 6 ? 24 : version >= 4 ? 16 : 8;
    long rules = syscall(CREATE_RULESET, &rights, size, 0);
    if (rules < 0)
        give_up("Landlock");
    return (int)rules;
}

// A file takes only rights that a file can have.
static void allow_place(int rules, int place, uint64_t rights)
{
    struct stat status;
    if (fstat(place, &status) != 0)
        give_up("stat");
    if (!S_ISDIR(status.st_mode))
        rights &= EXECUTE | WRITE_FILE | TRUNCATE | IOCTL;
    struct path_beneath beneath = {rights, place};
    if (syscall(ADD_RULE, rules, RULE_PATH_BENEATH, &beneath, 0) != 0)
        give_up("Landlock");
}

// What is not there needs no right.
static void allow_path(int rules, const char *path, uint64_t rights)
{
    int place = open(path, O_PATH | O_CLOEXEC);
    if (place < 0)
        return;
    allow_place(rules, place, rights);
    close(place);
}

static void landlock_end(int rules)
{
    if (syscall(RESTRICT_SELF, rules, 0) != 0)
        give_up("Landlock");
    close(rules);
}

// ---- system calls -------------------------------------------------------------------------------

// The filters, as libseccomp makes them.
static scmp_filter_ctx filter;

static void rule(uint32_t action, int call, unsigned count, const struct scmp_arg_cmp *arguments)
{
    if (call < 0) // unknown on this machine
        return;
    errno = -seccomp_rule_add_array(filter, action, call, count, arguments);
    if (errno != 0)
        give_up("seccomp");
}

// These bits of argument n, or its lower 32, are those of the value.
static struct scmp_arg_cmp bits(unsigned n, uint32_t mask, uint32_t value)
{
    return (struct scmp_arg_cmp){n, SCMP_CMP_MASKED_EQ, mask, value};
}

static struct scmp_arg_cmp is(unsigned n, uint32_t value)
{
    return bits(n, UINT32_MAX, value);
}

static void allow_where(int call, struct scmp_arg_cmp argument)
{
    rule(SCMP_ACT_ALLOW, call, 1, &argument);
}

// names: of system calls. Some are unknown on this machine, but none is to libseccomp.
static void rule_for_each(uint32_t action, const char *names)
{
    char name[40];
    for (int length; sscanf(names, " %39s%n", name, &length) == 1; names += length) {
        int call = seccomp_syscall_resolve_name(name);
        errno = EINVAL;
        if (call == __NR_SCMP_ERROR)
            give_up(name);
        rule(action, call, 0, NULL);
    }
}

static void filter_begin(uint32_t by_default)
{
    filter = seccomp_init(by_default);
    if (filter == NULL)
        give_up("seccomp");
}

static void filter_end(void)
{
    errno = -seccomp_load(filter);
    if (errno != 0)
        give_up("seccomp");
    seccomp_release(filter);
}

// A student's answers: memory, mathematics, their pipes (read 3, write 1, 2 and 4). Anything else
// ends the process with SIGSYS. It can be started once, from this descriptor.
static void allow_answers(int program)
{
    filter_begin(SCMP_ACT_TRAP);
    seccomp_attr_set(filter, SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS);
    rule_for_each(SCMP_ACT_ALLOW, "brk munmap mremap exit exit_group rt_sigaction rt_sigprocmask "
                                  "rt_sigreturn sigaltstack arch_prctl set_tid_address "
                                  "set_robust_list rseq");
    // The C library asks these and does without; an answer learns nothing that differs between
    // runs.
    rule_for_each(SCMP_ACT_ERRNO(ENOSYS), "newfstatat fstat statx readlink readlinkat lseek getpid "
                                          "gettid getrandom clock_gettime");
    rule_for_each(SCMP_ACT_ERRNO(ENOTTY), "ioctl");
    // What the C library asks for. Others poison memory, or tell what is in it.
    const int advice[] = {MADV_DONTNEED, MADV_FREE};
    for (size_t i = 0; i < sizeof advice / sizeof advice[0]; i++)
        allow_where(SCMP_SYS(madvise), is(2, (uint32_t)advice[i]));
    allow_where(SCMP_SYS(read), is(0, 3));
    for (unsigned out = 1; out <= 4; out += out) { // 1, 2, 4
        allow_where(SCMP_SYS(write), is(0, out));
        if (out < 4)
            allow_where(SCMP_SYS(writev), is(0, out));
    }
    // Until the program starts, which closes it.
    allow_where(SCMP_SYS(write), is(0, START_ERROR));
    // Memory that is neither a file nor code.
    rule(SCMP_ACT_ALLOW, SCMP_SYS(mmap), 2,
         (const struct scmp_arg_cmp[]){bits(2, PROT_EXEC, 0),
                                       bits(3, MAP_ANONYMOUS, MAP_ANONYMOUS)});
    allow_where(SCMP_SYS(mprotect), bits(2, PROT_EXEC, 0));
    // To ask for limits, not to set them.
    rule(SCMP_ACT_ALLOW, SCMP_SYS(prlimit64), 2,
         (const struct scmp_arg_cmp[]){is(0, 0), {2, SCMP_CMP_EQ, 0, 0}});
    // To be started: from a descriptor that is gone then, and that cannot be had again.
    rule(SCMP_ACT_ALLOW, SCMP_SYS(execveat), 2,
         (const struct scmp_arg_cmp[]){is(0, (uint32_t)program), is(4, AT_EMPTY_PATH)});
    filter_end();
}

// A compiler: all but what only an attack on the compiler itself would want. It runs no code of the
// student's.
static void allow_compiler(void)
{
    filter_begin(SCMP_ACT_ALLOW);
    rule_for_each(SCMP_ACT_ERRNO(EPERM),
                  "socket socketpair connect bind listen ptrace process_vm_readv "
                  "process_vm_writev pidfd_open pidfd_getfd pidfd_send_signal kcmp mount "
                  "umount2 pivot_root chroot open_tree move_mount fsopen fsmount unshare "
                  "setns setsid bpf perf_event_open userfaultfd io_uring_setup keyctl "
                  "add_key request_key memfd_create open_by_handle_at name_to_handle_at "
                  "mknod mknodat chown fchownat setuid setgid reboot swapon init_module "
                  "finit_module kexec_load sethostname settimeofday clock_settime shmget "
                  "msgget semget mq_open");
    filter_end();
}

// ---- how what is started ends -------------------------------------------------------------------

// A compiler's words about a text can be forged by that text (#error, #line), so a machine that
// failed is distinguished from a wrong text by exit statuses and signals alone.

// When a child ends, its own children become children of this process, so that at last all are
// gone.
static void end_all(void)
{
    char path[60];
    snprintf(path, sizeof path, "/proc/self/task/%d/children", (int)getpid());
    do {
        FILE *children = fopen(path, "r");
        int child;
        while (children != NULL && fscanf(children, "%d", &child) == 1)
            kill(child, SIGKILL);
        if (children != NULL)
            fclose(children);
    } while (wait(NULL) > 0);
}

static _Noreturn void run(char **command, const sigset_t *signals, pid_t watcher)
{
    sigprocmask(SIG_UNBLOCK, signals, NULL);
    // A command that asks for this itself may be too late: whoever wants it would wait for it in
    // vain.
    prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
    if (getppid() != watcher)
        _exit(126);
    execvp(command[0], command);
    give_up(command[0]);
    _exit(126);
}

// Runs the command and ends as it does, with all that is left of it; at once if the parent ends,
// however that ends. parent: the process that wants the command, which may have ended by now.
static _Noreturn void watch(pid_t parent, char **command)
{
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGTERM);
    sigaddset(&signals, SIGCHLD);
    if (sigprocmask(SIG_BLOCK, &signals, NULL) != 0 ||
        prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0) != 0 ||
        prctl(PR_SET_PDEATHSIG, SIGTERM, 0, 0, 0) != 0)
        give_up("to watch");
    if (getppid() != parent) // the parent ended before it could be watched
        exit(1);
    pid_t watcher = getpid(), child = fork();
    if (child < 0)
        give_up("fork");
    if (child == 0)
        run(command, &signals, watcher);
    for (;;) {
        int number = sigwaitinfo(&signals, NULL), status;
        if (number == SIGTERM) {
            end_all();
            exit(1);
        }
        for (pid_t ended; (ended = waitpid(-1, &status, WNOHANG)) > 0;)
            if (ended == child) {
                end_all();
                exit(WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status));
            }
    }
}

// The exit statuses of run_tool, as tests/grade/mark/commands.py reads them. All but the last are
// due to the text that was compiled.
enum {
    TOOL_REFUSES = 90, // exit status 1: it says what is wrong with the text
    TOOL_WORK = 91,    // more work than the limit
    TOOL_FILE = 92,    // a larger file than the limit
    TOOL_CRASHED = 93, // a fault of its own: memory, stack, assertion
    TOOL_ODD = 94,     // another exit status: it found an error in itself
    TOOL_ENDED = 99,   // ended by somebody else, or could not be started
};

static int status_of_signal(int number)
{
    switch (number) {
    case SIGXCPU:
        return TOOL_WORK;
    case SIGXFSZ:
        return TOOL_FILE;
    case SIGSEGV:
    case SIGABRT:
    case SIGILL:
    case SIGFPE:
        return TOOL_CRASHED;
    default:
        return TOOL_ENDED;
    }
}

static int run_tool(char **command)
{
    pid_t child = fork();
    if (child == 0) {
        execvp(command[0], command);
        fprintf(stderr, "confine: %s: %s\n", command[0], strerror(errno));
        kill(getpid(), SIGKILL); // no exit status of a tool could be mistaken for this
    }
    int status;
    if (child < 0 || waitpid(child, &status, 0) != child)
        return TOOL_ENDED;
    if (WIFSIGNALED(status))
        return status_of_signal(WTERMSIG(status));
    return WEXITSTATUS(status) == 0 ? 0 : WEXITSTATUS(status) == 1 ? TOOL_REFUSES : TOOL_ODD;
}

// 0 if that number of processes can exist at a time.
static int room_for(int processes)
{
    int ends[2] = {-1, -1}, started = 0;
    if (pipe(ends) == 0)
        while (started < processes) {
            pid_t child = fork();
            if (child < 0)
                break;
            if (child == 0) {
                char byte;
                close(ends[1]);
                _exit(read(ends[0], &byte, 1) < 0);
            }
            started++;
        }
    if (started < processes)
        fprintf(stderr, "only %d of %d processes can be started: %s\n", started, processes,
                strerror(errno));
    close(ends[1]); // ends them all
    while (wait(NULL) > 0)
        ;
    return started < processes;
}

// ---- what is started ----------------------------------------------------------------------------

// option: of the shell's ulimit
static void limit_both(__rlimit_resource_t what, rlim_t soft, rlim_t hard, char option)
{
    struct rlimit limits = {soft, hard};
    if (setrlimit(what, &limits) == 0)
        return;
    char words[80];
    snprintf(words, sizeof words, "the hard limit 'ulimit -%c' of this machine is too low", option);
    give_up(words);
}

static void limit(__rlimit_resource_t what, rlim_t most, char option)
{
    limit_both(what, most, most, option);
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
        allow_place(rules, PROGRAM, EXECUTE);
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
        uint64_t rights = all_rights();
        allow_path(rules, "/dev/null", rights);
        for (char **place = places; place < command - 1; place++) {
            if (strcmp(*place, "-") == 0)
                rights = READ;
            else
                allow_path(rules, *place, rights);
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
    limit_both(RLIMIT_CPU, COMPILE_SECONDS, COMPILE_SECONDS + 1, 't');
    struct rlimit processes; // shared machines allow fewer
    if (getrlimit(RLIMIT_NPROC, &processes) != 0)
        give_up("getrlimit");
    limit(RLIMIT_NPROC, MIN(processes.rlim_max, (rlim_t)COMPILE_PROCESSES), 'u');
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
    bool has_command = *command != NULL && command[1] != NULL;
    if (strcmp(mode, "watch") == 0 && has_command && command == argv + 3)
        watch(atoi(argv[2]), command + 1);
    bool answer = argc == 3 && strcmp(mode, "answer") == 0;
    bool compile = argc > 4 && strcmp(mode, "compile") == 0 && has_command;
    bool judge = argc > 4 && strcmp(mode, "judge") == 0 && has_command;
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
