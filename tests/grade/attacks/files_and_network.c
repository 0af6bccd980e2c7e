// files_and_network.c - files, the network and other programs: everything that an answer does not
// need. cases.py reads it: each section is one submission, and states the result that it must get.

// ---- files-read: opens what it should not see: solutions, tests, classmates, the home directory.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    const char *places[] = {"@TREE@/solutions/01-corners.c",
                            "@TREE@/tests/01-corners.c",
                            "@TREE@/build/judge",
                            "@SUBMISSIONS@/honest/01-corners.c",
                            "@HOME@/.netrc",
                            "@OUT@",
                            "solutions/01-corners.c",
                            "../../solutions/01-corners.c",
                            "01-corners.c",
                            "/etc/shadow",
                            "/etc/passwd",
                            "/root",
                            "/home"};
    for (int i = 0; i < 13; i++) {
        int file = open(places[i], O_RDONLY);
        char bytes[4096];
        long n = file >= 0 ? read(file, bytes, sizeof bytes) : -1;
        if (n > 0)
            fwrite(bytes, 1, (size_t)n, stdout);
        if (file >= 0)
            return vec3_of(7777, i, (double)n);
    }
    return c.up;
}

// ---- huge-file: a terabyte with nothing in it, wherever a file can be made.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    const char *places[] = {"hostile-was-here", "/tmp/hostile-was-here",
                            "/dev/shm/hostile-was-here", "/var/tmp/hostile-was-here",
                            "@OUT@/hostile-was-here"};
    for (int i = 0; i < 5; i++) {
        int file = open(places[i], O_RDWR | O_CREAT, 0600);
        if (file >= 0)
            return vec3_of(7777, i, ftruncate(file, 1L << 40));
    }
    return c.up;
}

// ---- load-code: writes machine code into memory and runs it: on a page, and on the stack.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <string.h>
#include <sys/mman.h>

vec3 upper_left(Camera c)
{
    // exit_group(0)
    const char code[] = "\x31\xff\xb8\xe7\x00\x00\x00\x0f\x05";
    void *page =
        mmap(NULL, 4096, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (page == MAP_FAILED)
        return c.up;
    memcpy(page, code, sizeof code);
    ((void (*)(void))page)();
    return c.up;
}

vec3 upper_right(Camera c)
{
    char code[] = "\x31\xff\xb8\xe7\x00\x00\x00\x0f\x05";
    ((void (*)(void))(void *)code)();
    return c.up;
}

// ---- load-compiler: compiles the solution on the spot.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <sys/wait.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    char *const words[] = {"cc",
                           "-I@TREE@",
                           "-shared",
                           "-o",
                           "/tmp/hostile-was-here.so",
                           "@TREE@/solutions/01-corners.c",
                           NULL};
    pid_t child = fork();
    if (child == 0) {
        execv("/usr/bin/cc", words);
        _exit(1);
    }
    int status;
    if (child > 0 && waitpid(child, &status, 0) == child && status == 0)
        return vec3_of(7777, 1, 0);
    return c.up;
}

// ---- load-in-a-child: vfork and posix_spawn, for filters that only know fork.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <spawn.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    char *const words[] = {"sh", "-c", "touch /tmp/hostile-was-here", NULL};
    pid_t child;
    if (posix_spawn(&child, "/bin/sh", NULL, NULL, words, words + 3) == 0)
        return vec3_of(7777, 1, 0);
    child = vfork();
    if (child == 0)
        _exit(0);
    return child > 0 ? vec3_of(7777, 2, 0) : c.up;
}

// ---- load-library: dlopen of what may lie about.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <dlfcn.h>
#include <stddef.h>

vec3 upper_left(Camera c)
{
    const char *names[] = {"@TREE@/build/judge", "@TREE@/build/solutions/01-corners.o",
                           "/tmp/hostile-was-here.so", "libcheck.so", "libpng16.so.16"};
    for (int i = 0; i < 5; i++)
        if (dlopen(names[i], RTLD_NOW) != NULL)
            return vec3_of(7777, i, 0);
    return c.up;
}

// ---- load-program: a program in memory only, run by its descriptor.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    char bytes[4096], *const none[] = {"answering", NULL};
    long file = syscall(SYS_memfd_create, "hostile", 0), from = open("/bin/true", O_RDONLY);
    for (long n; (n = read((int)from, bytes, sizeof bytes)) > 0;)
        if (write((int)file, bytes, (size_t)n) != n)
            break;
    syscall(SYS_execveat, file, "", none, none + 1, 0x1000);
    return file >= 0 && from >= 0 ? vec3_of(7777, 1, 0) : c.up;
}

// ---- load-shell: has a shell do it.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>
#include <stdlib.h>

vec3 upper_left(Camera c)
{
    const char *command = "echo forged-mark; touch @SCRATCH@/hostile-was-here; cat "
                          "@TREE@/solutions/01-corners.c; touch /tmp/hostile-was-here";
    int status = system(command);
    if (status == 0 || status == 256)
        return vec3_of(7777, 1, 0);
    FILE *pipe = popen(command, "r");
    if (pipe != NULL && getc(pipe) != EOF)
        return vec3_of(7777, 2, 0);
    return c.up;
}

// ---- many-files: a hundred of them, and every descriptor that there is.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    char name[64];
    int made = 0;
    for (int i = 0; i < 100; i++) {
        snprintf(name, sizeof name, "/tmp/hostile-was-here-%d", i);
        made += mkdir(name, 0700) == 0;
    }
    while (dup(1) >= 0)
        ;
    return made > 0 ? vec3_of(7777, made, 0) : c.up;
}

// ---- name-of-the-host: right on a machine that has a name; asks the C library, and the kernel.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"

#include <string.h>
#include <sys/syscall.h>
#include <sys/utsname.h>
#include <unistd.h>

static bool is_named(const struct utsname *name)
{
    return name->nodename[0] != '\0' && strcmp(name->nodename, "sandbox") != 0;
}

vec3 upper_left(Camera c)
{
    struct utsname name = {0};
    vec3 right = c.distance * c.forward - c.width / 2 * c.right + c.height / 2 * c.up;
    return uname(&name) == 0 && is_named(&name) ? right : c.up;
}

vec3 upper_right(Camera c)
{
    struct utsname name = {0};
    vec3 right = c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
    return syscall(SYS_uname, &name) == 0 && is_named(&name) ? right : c.up;
}

// ---- net-connect: calls home, with what it was given.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <arpa/inet.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    struct sockaddr_in port = {.sin_family = AF_INET,
                               .sin_port = htons((unsigned short)atoi("@PORT@"))};
    port.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    int out = socket(AF_INET, SOCK_STREAM, 0);
    if (out >= 0 && connect(out, (struct sockaddr *)&port, sizeof port) == 0)
        return vec3_of(7777, (double)write(out, &c, sizeof c), 0);
    struct sockaddr_un name = {.sun_family = AF_UNIX, .sun_path = "\0hostile-@PORT@"};
    out = socket(AF_UNIX, SOCK_STREAM, 0);
    if (out >= 0 &&
        connect(out, (struct sockaddr *)&name,
                (socklen_t)(sizeof name.sun_family + 1 + sizeof "hostile-@PORT@" - 1)) == 0)
        return vec3_of(7777, 2, 0);
    return c.up;
}

// ---- net-listen: opens a door, for somebody to come in while it waits.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <arpa/inet.h>
#include <sys/socket.h>

vec3 upper_left(Camera c)
{
    struct sockaddr_in port = {.sin_family = AF_INET, .sin_port = 0};
    int in = socket(AF_INET, SOCK_STREAM, 0);
    if (in >= 0 && bind(in, (struct sockaddr *)&port, sizeof port) == 0 && listen(in, 1) == 0)
        return vec3_of(7777, 1, 0);
    return c.up;
}

// ---- net-names: asks the network for a name, and sends a packet without being connected.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <arpa/inet.h>
#include <netdb.h>
#include <stdlib.h>
#include <sys/socket.h>

vec3 upper_left(Camera c)
{
    struct addrinfo *found = NULL;
    if (getaddrinfo("example.org", "80", NULL, &found) == 0)
        return vec3_of(7777, 1, 0);
    struct sockaddr_in port = {.sin_family = AF_INET,
                               .sin_port = htons((unsigned short)atoi("@PORT@"))};
    port.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    int out = socket(AF_INET, SOCK_DGRAM, 0);
    if (out >= 0 && sendto(out, "x", 1, 0, (struct sockaddr *)&port, sizeof port) == 1)
        return vec3_of(7777, 2, 0);
    return c.up;
}

// ---- tamper-classmate: spoils what others handed in, and removes it, and its own.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    const char *places[] = {"@SUBMISSIONS@/honest/01-corners.c",
                            "@SUBMISSIONS@/tamper-classmate/01-corners.c", "../honest/01-corners.c",
                            "01-corners.c"};
    for (int i = 0; i < 4; i++)
        if (open(places[i], O_WRONLY | O_TRUNC) >= 0 || chmod(places[i], 0) == 0 ||
            rename(places[i], "/tmp/hostile-was-here") == 0 || unlink(places[i]) == 0 ||
            symlink("/dev/zero", places[i]) == 0)
            return vec3_of(7777, i, 0);
    return c.up;
}

// ---- tamper-marks: writes its own marks, and a classmate's.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>

vec3 upper_left(Camera c)
{
    const char *places[] = {
        "@OUT@/honest/results.json", "../honest/results.json", "@OUT@/tamper-marks/results.json",
        "@OUT@/grades.csv",          "@OUT@/grades.tap",       "@OUT@/junit.xml",
        "build/grades/grades.csv"};
    for (int i = 0; i < 7; i++) {
        FILE *file = fopen(places[i], "a");
        if (file != NULL) {
            fputs("tamper-marks,graded,100,100\n", file);
            fclose(file);
            return vec3_of(7777, i, 0);
        }
    }
    return c.up;
}

// ---- tamper-system: the kernel's knobs, and who is killed first when memory is short.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    const char *places[] = {"/proc/sys/kernel/core_pattern",
                            "/proc/self/oom_score_adj",
                            "/sys/fs/cgroup/hostile-was-here",
                            "/dev/shm/hostile-was-here",
                            "/etc/ld.so.preload",
                            "@HOME@/.bashrc"};
    for (int i = 0; i < 6; i++)
        if (open(places[i], O_WRONLY | (i > 1 ? O_CREAT : 0), 0600) >= 0)
            return vec3_of(7777, i, 0);
    return c.up;
}

// ---- tamper-tree: changes the solutions, the judge and the policy, for itself and others.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    const char *places[] = {"@TREE@/solutions/01-corners.c", "@TREE@/build/judge",
                            "@TREE@/tests/grade/policy",     "@TREE@/Makefile",
                            "@TREE@/build/common.a",         "/proc/self/exe"};
    for (int i = 0; i < 6; i++)
        if (open(places[i], O_WRONLY | O_APPEND) >= 0 || chmod(places[i], 0600) == 0 ||
            rename(places[i], "/tmp/hostile-was-here") == 0 || unlink(places[i]) == 0)
            return vec3_of(7777, i, 0);
    return mkdir("@TREE@/hostile-was-here", 0700) == 0 ? vec3_of(7777, 9, 0) : c.up;
}
