// system_calls.c - the filters, as libseccomp makes them.
#define _GNU_SOURCE
#include "tests/grade/confine/system_calls.h"

#include "tests/grade/confine/give_up.h"
#include "tests/judge/answering.h"

#include <errno.h>
#include <fcntl.h>
#include <seccomp.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/mman.h>

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

void allow_answers(int program)
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
                            SCMP_SYS(rseq)};
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

void allow_compiler(void)
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
