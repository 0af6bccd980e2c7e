// confine - starts a program that may do next to nothing, because what it holds is hostile.
//
//   confine answer PROGRAM                   a student's answers: memory, mathematics, and the
//   pipes
//                                            that are open already (3 in, 4 out; print to 1 and 2)
//   confine compile WRITABLE... - READABLE... -- PROGRAM ARGUMENT...
//                                            a compiler on a student's text: files in these places
//   confine probe                            says what this kernel has: 'landlock', 'seccomp'
//
// Limits, then Landlock (files, network, signals), then seccomp (system calls); each alone would do
// for most attacks. What the program does, its children inherit. Exit status 126: could not be
// confined.
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <linux/landlock.h>
#include <sched.h>
#include <seccomp.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
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
    COMPILE_SECONDS = 5, // of work for each file
};

static void give_up(const char *what)
{
    fprintf(stderr, "confine: %s: %s\n", what, strerror(errno));
    exit(126);
}

static void limit(__rlimit_resource_t what, rlim_t most)
{
    struct rlimit limits = {most, most};
    if (setrlimit(what, &limits) != 0)
        give_up("setrlimit");
}

// ---- Landlock: what of the file system, the network and other processes can be reached ---------

static int landlock_version(void)
{
    long version = syscall(SYS_landlock_create_ruleset, NULL, 0, LANDLOCK_CREATE_RULESET_VERSION);
    return version < 0 ? 0 : (int)version;
}

// Newer kernels know more rights than the headers that this was compiled with.
struct rights {
    uint64_t files, network, scoped;
};
enum {
    READ = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR | LANDLOCK_ACCESS_FS_EXECUTE,
    ALL_1 = (1 << 13) - 1, // of version 1
    REFER = 1 << 13,       // 2
    TRUNCATE = 1 << 14,    // 3
    NETWORK = 3,           // 4: bind, connect
    IOCTL = 1 << 15,       // 5
    SCOPED = 3,            // 6: abstract sockets, signals
};

static int landlock_begin(int version)
{
    struct rights rights = {.files = ALL_1};
    if (version >= 2)
        rights.files |= REFER;
    if (version >= 3)
        rights.files |= TRUNCATE;
    if (version >= 4)
        rights.network = NETWORK;
    if (version >= 5)
        rights.files |= IOCTL;
    if (version >= 6)
        rights.scoped = SCOPED;
    size_t size = version >= 6 ? 24 : version >= 4 ? 16 : 8;
    long ruleset = syscall(SYS_landlock_create_ruleset, &rights, size, 0);
    if (ruleset < 0)
        give_up("Landlock");
    return (int)ruleset;
}

// A file takes only rights that a file can have.
static void landlock_allow(int ruleset, int place, uint64_t rights)
{
    struct stat status;
    if (fstat(place, &status) != 0)
        give_up("stat");
    if (!S_ISDIR(status.st_mode))
        rights &= LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_EXECUTE |
                  LANDLOCK_ACCESS_FS_WRITE_FILE | TRUNCATE;
    struct landlock_path_beneath_attr rule = {rights, place};
    if (syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) != 0)
        give_up("Landlock");
}

static void landlock_allow_path(int ruleset, const char *path, uint64_t rights)
{
    int place = open(path, O_PATH | O_CLOEXEC);
    if (place < 0)
        return; // not on this system
    landlock_allow(ruleset, place, rights);
    close(place);
}

static void landlock_end(int ruleset)
{
    if (syscall(SYS_landlock_restrict_self, ruleset, 0) != 0)
        give_up("Landlock");
    close(ruleset);
}

// ---- seccomp: which system calls ---------------------------------------------------------------

static scmp_filter_ctx filter;

static void rule(uint32_t action, int call, unsigned count, const struct scmp_arg_cmp *arguments)
{
    if (call < 0) // unknown on this machine
        return;
    errno = -seccomp_rule_add_array(filter, action, call, count, arguments);
    if (errno != 0)
        give_up("seccomp");
}

static void allow(int call)
{
    rule(SCMP_ACT_ALLOW, call, 0, NULL);
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

static void refuse(int call, int error)
{
    rule(SCMP_ACT_ERRNO((uint32_t)error), call, 0, NULL);
}

static void filter_begin(uint32_t otherwise)
{
    filter = seccomp_init(otherwise);
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

// What is not named here ends the process with SIGSYS, and the judge says what it wanted.
static void allow_answers(void)
{
    filter_begin(SCMP_ACT_TRAP);
    seccomp_attr_set(filter, SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS);
    const int harmless[] = {SCMP_SYS(brk),
                            SCMP_SYS(munmap),
                            SCMP_SYS(mremap),
                            SCMP_SYS(madvise),
                            SCMP_SYS(exit),
                            SCMP_SYS(exit_group),
                            SCMP_SYS(rt_sigaction),
                            SCMP_SYS(rt_sigprocmask),
                            SCMP_SYS(rt_sigreturn),
                            SCMP_SYS(sigaltstack),
                            SCMP_SYS(arch_prctl),
                            SCMP_SYS(set_tid_address),
                            SCMP_SYS(set_robust_list),
                            SCMP_SYS(rseq),
                            SCMP_SYS(uname)};
    for (size_t i = 0; i < sizeof harmless / sizeof harmless[0]; i++)
        allow(harmless[i]);
    // The C library asks these and does without; an answer learns nothing that differs between
    // runs.
    const int refused[] = {SCMP_SYS(newfstatat), SCMP_SYS(fstat),        SCMP_SYS(statx),
                           SCMP_SYS(readlink),   SCMP_SYS(readlinkat),   SCMP_SYS(ioctl),
                           SCMP_SYS(lseek),      SCMP_SYS(getpid),       SCMP_SYS(gettid),
                           SCMP_SYS(getrandom),  SCMP_SYS(clock_gettime)};
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++)
        refuse(refused[i], refused[i] == SCMP_SYS(ioctl) ? ENOTTY : ENOSYS);
    allow_where(SCMP_SYS(read), is(0, 3));
    for (unsigned out = 1; out <= 4; out += out) { // 1, 2, 4
        allow_where(SCMP_SYS(write), is(0, out));
        if (out < 4)
            allow_where(SCMP_SYS(writev), is(0, out));
    }
    // Memory that is no file and never code.
    rule(SCMP_ACT_ALLOW, SCMP_SYS(mmap), 2,
         (const struct scmp_arg_cmp[]){bits(2, PROT_EXEC, 0),
                                       bits(3, MAP_ANONYMOUS, MAP_ANONYMOUS)});
    allow_where(SCMP_SYS(mprotect), bits(2, PROT_EXEC, 0));
    // To ask for limits, not to set them.
    rule(SCMP_ACT_ALLOW, SCMP_SYS(prlimit64), 2,
         (const struct scmp_arg_cmp[]){is(0, 0), {2, SCMP_CMP_EQ, 0, 0}});
    // To be started: from a descriptor that is gone then, and that cannot be had again.
    rule(SCMP_ACT_ALLOW, SCMP_SYS(execveat), 2,
         (const struct scmp_arg_cmp[]){is(0, PROGRAM), is(4, AT_EMPTY_PATH)});
    filter_end();
}

// A compiler runs no code of the student's, so what it needs is not listed, but what only an attack
// on the compiler itself would want.
static void refuse_compilers(void)
{
    filter_begin(SCMP_ACT_ALLOW);
    const int refused[] = {SCMP_SYS(socket),
                           SCMP_SYS(socketpair),
                           SCMP_SYS(connect),
                           SCMP_SYS(bind),
                           SCMP_SYS(listen),
                           SCMP_SYS(ptrace),
                           SCMP_SYS(process_vm_readv),
                           SCMP_SYS(process_vm_writev),
                           SCMP_SYS(pidfd_open),
                           SCMP_SYS(pidfd_getfd),
                           SCMP_SYS(pidfd_send_signal),
                           SCMP_SYS(kcmp),
                           SCMP_SYS(mount),
                           SCMP_SYS(umount2),
                           SCMP_SYS(pivot_root),
                           SCMP_SYS(chroot),
                           SCMP_SYS(open_tree),
                           SCMP_SYS(move_mount),
                           SCMP_SYS(fsopen),
                           SCMP_SYS(fsmount),
                           SCMP_SYS(unshare),
                           SCMP_SYS(setns),
                           SCMP_SYS(setsid),
                           SCMP_SYS(bpf),
                           SCMP_SYS(perf_event_open),
                           SCMP_SYS(userfaultfd),
                           SCMP_SYS(io_uring_setup),
                           SCMP_SYS(keyctl),
                           SCMP_SYS(add_key),
                           SCMP_SYS(request_key),
                           SCMP_SYS(memfd_create),
                           SCMP_SYS(open_by_handle_at),
                           SCMP_SYS(name_to_handle_at),
                           SCMP_SYS(mknod),
                           SCMP_SYS(mknodat),
                           SCMP_SYS(chown),
                           SCMP_SYS(fchownat),
                           SCMP_SYS(setuid),
                           SCMP_SYS(setgid),
                           SCMP_SYS(reboot),
                           SCMP_SYS(swapon),
                           SCMP_SYS(init_module),
                           SCMP_SYS(finit_module),
                           SCMP_SYS(kexec_load),
                           SCMP_SYS(sethostname),
                           SCMP_SYS(settimeofday),
                           SCMP_SYS(clock_settime),
                           SCMP_SYS(shmget),
                           SCMP_SYS(msgget),
                           SCMP_SYS(semget),
                           SCMP_SYS(mq_open)};
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++)
        refuse(refused[i], EPERM);
    filter_end();
}

// ---- the two kinds of programs ------------------------------------------------------------------

static void start_answers(const char *program)
{
    int file = open(program, O_RDONLY | O_CLOEXEC);
    if (file < 0 || dup3(file, PROGRAM, O_CLOEXEC) != PROGRAM)
        give_up(program);
    close(file);
    int landlock = landlock_version();
    if (landlock > 0) {
        int ruleset = landlock_begin(landlock);
        landlock_allow(ruleset, PROGRAM, LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE);
        landlock_end(ruleset);
    }
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, ANSWER_PRINTED);
    limit(RLIMIT_AS, ANSWER_MEMORY);
    limit(RLIMIT_CPU, ANSWER_SECONDS);
    limit(RLIMIT_NPROC, 1);
    limit(RLIMIT_NOFILE, 5);
    // The same addresses and no clock, so that nothing differs between two runs.
    personality(ADDR_NO_RANDOMIZE);
#ifdef PR_SET_TSC
    prctl(PR_SET_TSC, PR_TSC_SIGSEGV, 0, 0, 0);
#endif
    allow_answers();
    char *const arguments[] = {(char *)"answering", NULL}, *const environment[] = {NULL};
    syscall(SYS_execveat, PROGRAM, "", arguments, environment, AT_EMPTY_PATH);
    _exit(127);
}

static void start_compiler(char **places, char **command)
{
    int landlock = landlock_version();
    if (landlock > 0) {
        int ruleset = landlock_begin(landlock);
        uint64_t all = ALL_1 | (landlock >= 2 ? REFER : 0) | (landlock >= 3 ? TRUNCATE : 0);
        landlock_allow_path(ruleset, "/dev/null", all);
        uint64_t rights = all;
        for (char **place = places; place < command - 1; place++) {
            if (strcmp(*place, "-") == 0)
                rights = READ;
            else
                landlock_allow_path(ruleset, *place, rights);
        }
        landlock_end(ruleset);
    }
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, COMPILE_FILE);
    limit(RLIMIT_AS, COMPILE_MEMORY);
    limit(RLIMIT_CPU, COMPILE_SECONDS);
    limit(RLIMIT_NOFILE, 64);
    refuse_compilers();
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
    char **command = argv + (argc > 0 ? 1 : 0);
    while (*command != NULL && strcmp(*command, "--") != 0)
        command++;
    bool answer = argc == 3 && strcmp(mode, "answer") == 0;
    bool compile =
        argc > 4 && strcmp(mode, "compile") == 0 && *command != NULL && command[1] != NULL;
    if (!answer && !compile) {
        fprintf(stderr,
                "Usage: confine answer PROGRAM | compile WRITABLE... - READABLE... -- PROGRAM "
                "ARGUMENT... | probe\n");
        return 2;
    }
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
        give_up("no new privileges");
    if (answer)
        start_answers(argv[2]);
    start_compiler(argv + 2, command + 1);
}
