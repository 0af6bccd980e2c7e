// system_calls.c - the filters, as libseccomp makes them.
#define _GNU_SOURCE
#include "tests/grade/confine/confine.h"
#include "tests/judge/process.h"

#include <errno.h>
#include <fcntl.h>
#include <seccomp.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
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

static void refuse_as_unknown(int call)
{
    refuse(call, ENOSYS);
}

static void refuse_as_forbidden(int call)
{
    refuse(call, EPERM);
}

// names: of system calls. Some are unknown on this machine, but none is to libseccomp.
static void call_each(void (*treat)(int call), const char *names)
{
    char name[40];
    for (int length; sscanf(names, " %39s%n", name, &length) == 1; names += length) {
        int call = seccomp_syscall_resolve_name(name);
        errno = EINVAL;
        if (call == __NR_SCMP_ERROR)
            give_up(name);
        treat(call);
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

void allow_answers(int program)
{
    filter_begin(SCMP_ACT_TRAP);
    seccomp_attr_set(filter, SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS);
    call_each(allow, "brk munmap mremap exit exit_group rt_sigaction rt_sigprocmask rt_sigreturn "
                     "sigaltstack arch_prctl set_tid_address set_robust_list rseq");
    // The C library asks these and does without; an answer learns nothing that differs between
    // runs.
    call_each(refuse_as_unknown, "newfstatat fstat statx readlink readlinkat lseek getpid gettid "
                                 "getrandom clock_gettime");
    refuse(SCMP_SYS(ioctl), ENOTTY);
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

void allow_compiler(void)
{
    filter_begin(SCMP_ACT_ALLOW);
    call_each(refuse_as_forbidden,
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
