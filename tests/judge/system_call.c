// system_call.c - what a forbidden system call was for, in words.
#define _GNU_SOURCE
#include "tests/judge/process.h"

#include <stddef.h>
#include <sys/syscall.h>

static const struct {
    int number;
    const char *purpose;
} known[] = {
    {SYS_openat, "to open a file"},
    {SYS_unlinkat, "to remove a file"},
    {SYS_mkdirat, "to make a folder"},
    {SYS_socket, "the network"},
    {SYS_socketpair, "to start another program"},
    {SYS_pipe2, "to start another program"},
    {SYS_execve, "to start another program"},
    {SYS_execveat, "to start another program"},
    {SYS_clone, "to start a process or a thread"},
#ifdef SYS_clone3
    {SYS_clone3, "to start a process or a thread"},
#endif
#ifdef SYS_open
    {SYS_open, "to open a file"},
    {SYS_unlink, "to remove a file"},
    {SYS_mkdir, "to make a folder"},
    {SYS_fork, "to start a process or a thread"},
    {SYS_vfork, "to start a process or a thread"},
    {SYS_pipe, "to start another program"},
    {SYS_time, "the time"},
    {SYS_alarm, "to be woken"},
    {SYS_pause, "to sleep"},
    {SYS_poll, "to sleep"},
    {SYS_select, "to sleep"},
    {SYS_getpgrp, "to know about processes"},
#endif
    {SYS_kill, "to send a signal"},
    {SYS_tkill, "to send a signal"},
    {SYS_tgkill, "to send a signal"},
    {SYS_setpgid, "to know about processes"},
    {SYS_setsid, "to know about processes"},
    {SYS_getppid, "to know about processes"},
    {SYS_getpid, "to know about processes"},
    {SYS_ptrace, "to look into another process"},
    {SYS_process_vm_readv, "to look into another process"},
    {SYS_process_vm_writev, "to look into another process"},
    {SYS_nanosleep, "to sleep"},
    {SYS_clock_nanosleep, "to sleep"},
    {SYS_ppoll, "to sleep"},
    {SYS_pselect6, "to sleep"},
    {SYS_clock_gettime, "the time"},
    {SYS_gettimeofday, "the time"},
    {SYS_getrandom, "random numbers"},
    {SYS_mmap, "code that is made while it runs, or a file"},
    {SYS_mprotect, "code that is made while it runs"},
    {SYS_memfd_create, "code that is made while it runs, or a file"},
    {SYS_read, "to read from elsewhere"},
    {SYS_write, "to write elsewhere"},
    {SYS_prctl, "to change its own limits"},
    {SYS_setrlimit, "to change its own limits"},
    {SYS_prlimit64, "to change its own limits"},
};

const char *system_call_purpose(int number)
{
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
        if (known[i].number == number)
            return known[i].purpose;
    return "something of the operating system";
}
