// files_and_network.c - files, the network and other programs: everything that an answer does not need.

// ---- files-read: opens what it should not see: solutions, tests, classmates, the home directory.
// -> graded | crashed
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

// ---- load-code: writes machine code into memory and runs it: on a page, and on the stack.
// -> graded | crashed
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

// ---- load-in-a-child: vfork and posix_spawn, for filters that only know fork.
// -> graded | crashed
#include <spawn.h>

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

// ---- load-program: a program in memory only, run by its descriptor.
// -> graded | crashed
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
// -> graded | crashed
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

// ---- made-files: a terabyte with nothing in it, wherever a file can be made; a hundred folders, and
// every descriptor that there is.
// -> graded | crashed
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

vec3 upper_right(Camera c)
{
    char name[64];
    int made = 0;
    for (int i = 0; i < 100; i++) {
        snprintf(name, sizeof name, "/tmp/hostile-was-here-%d", i);
        made += mkdir(name, 0700) == 0;
    }
    return made > 0 ? vec3_of(7777, made, 0) : c.up;
}

vec3 across_30_up_10(Camera c)
{
    while (dup(1) >= 0)
        ;
    return c.up;
}

// ---- name-of-the-host: right on a machine that has a name; asks the C library, and the kernel.
// -> graded | crashed
#include <sys/utsname.h>

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

// ---- net: calls home with what it was given, by two ways, waits for a caller, and asks for a name.
// -> graded | crashed | timed out
#include <arpa/inet.h>
#include <netdb.h>
#include <sys/socket.h>
#include <sys/un.h>

static const struct sockaddr *loopback(const char *number)
{
    static struct sockaddr_in port = {.sin_family = AF_INET};
    port.sin_port = htons((unsigned short)atoi(number));
    port.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return (const struct sockaddr *)&port;
}

vec3 upper_left(Camera c)
{
    int out = socket(AF_INET, SOCK_STREAM, 0);
    if (out >= 0 && connect(out, loopback("@PORT@"), sizeof(struct sockaddr_in)) == 0)
        return vec3_of(7777, (double)write(out, &c, sizeof c), 0);
    return c.up;
}

vec3 upper_right(Camera c)
{
    struct sockaddr_un name = {.sun_family = AF_UNIX, .sun_path = "\0hostile-@PORT@"};
    size_t size = sizeof name.sun_family + 1 + sizeof "hostile-@PORT@" - 1;
    int out = socket(AF_UNIX, SOCK_STREAM, 0);
    bool called = out >= 0 && connect(out, (struct sockaddr *)&name, (socklen_t)size) == 0;
    return called ? vec3_of(7777, 2, 0) : c.up;
}

vec3 across_30_up_10(Camera c)
{
    int in = socket(AF_INET, SOCK_STREAM, 0);
    bool listens = in >= 0 && bind(in, loopback("0"), sizeof(struct sockaddr_in)) == 0 &&
                   listen(in, 1) == 0;
    return listens ? vec3_of(7777, 3, 0) : c.up;
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    struct addrinfo *found = NULL;
    int out = socket(AF_INET, SOCK_DGRAM, 0);
    if (out >= 0 && sendto(out, "x", 1, 0, loopback("@PORT@"), sizeof(struct sockaddr_in)) == 1)
        return vec3_of(7777, 4, 0);
    return getaddrinfo("example.org", "80", NULL, &found) == 0 ? vec3_of(7777, 5, 0) : c.up;
}

// ---- tamper: spoils what classmates and itself handed in, the marks, the tree, and the system.
// -> graded | crashed
static vec3 spoil(Camera c, const char *const places[])
{
    for (int i = 0; places[i] != NULL; i++)
        if (open(places[i], O_WRONLY | O_APPEND) >= 0 || chmod(places[i], 0600) == 0 ||
            rename(places[i], "/tmp/hostile-was-here") == 0 || unlink(places[i]) == 0 ||
            open(places[i], O_WRONLY | O_CREAT, 0600) >= 0 || symlink("/dev/zero", places[i]) == 0)
            return vec3_of(7777, i, 0);
    return c.up;
}

vec3 upper_left(Camera c)
{
    return spoil(c, (const char *[]){"@SUBMISSIONS@/honest/01-corners.c",
                                     "@SUBMISSIONS@/tamper/01-corners.c", "../honest/01-corners.c",
                                     "01-corners.c", NULL});
}

vec3 upper_right(Camera c)
{
    return spoil(c, (const char *[]){"@OUT@/honest/results.json", "../honest/results.json",
                                     "@OUT@/tamper/results.json", "@OUT@/grades.csv",
                                     "@OUT@/grades.tap", "@OUT@/junit.xml",
                                     "build/grades/grades.csv", "/autograder/results/results.json",
                                     NULL});
}

vec3 across_30_up_10(Camera c)
{
    return spoil(c, (const char *[]){"@TREE@/solutions/01-corners.c", "@TREE@/build/judge",
                                     "@TREE@/tests/grade/policy", "@TREE@/Makefile",
                                     "@TREE@/build/common.a", "@TREE@/hostile-was-here",
                                     "/proc/self/exe", NULL});
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return spoil(c, (const char *[]){"/proc/sys/kernel/core_pattern", "/proc/self/oom_score_adj",
                                     "/sys/fs/cgroup/hostile-was-here", "/dev/shm/hostile-was-here",
                                     "/etc/ld.so.preload", "@HOME@/.bashrc", NULL});
}
