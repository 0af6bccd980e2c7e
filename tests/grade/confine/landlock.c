// landlock.c - Landlock's rules, by its system calls: the C library has no names for them, and
// older systems have no header (Debian 11 lacks it). The numbers are the kernel's, on every
// processor: https://docs.kernel.org/userspace-api/landlock.html
#define _GNU_SOURCE
#include "tests/grade/confine/confine.h"

#include <fcntl.h>
#include <stdint.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

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
    READ = EXECUTE | 1 << 3,   // and the folder
    ALL_1 = (1 << 13) - 1,     // of version 1
    REFER = 1 << 13,           // 2
    TRUNCATE = 1 << 14,        // 3
    NETWORK = 3,               // 4: bind, connect
    IOCTL = 1 << 15,           // 5
    SCOPED = 3,                // 6: abstract sockets, signals
};

int landlock_version(void)
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

int landlock_begin(void)
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
static void allow(int rules, int place, uint64_t rights)
{
    struct stat status;
    if (fstat(place, &status) != 0)
        give_up("stat");
    if (!S_ISDIR(status.st_mode))
        rights &= EXECUTE | WRITE_FILE | TRUNCATE | IOCTL;
    struct path_beneath rule = {rights, place};
    if (syscall(ADD_RULE, rules, RULE_PATH_BENEATH, &rule, 0) != 0)
        give_up("Landlock");
}

static void allow_path(int rules, const char *path, uint64_t rights)
{
    int place = open(path, O_PATH | O_CLOEXEC);
    if (place < 0)
        return;
    allow(rules, place, rights);
    close(place);
}

void landlock_allow_read(int rules, const char *path)
{
    allow_path(rules, path, READ);
}

void landlock_allow_all(int rules, const char *path)
{
    allow_path(rules, path, all_rights());
}

void landlock_allow_program(int rules, int file)
{
    allow(rules, file, EXECUTE);
}

void landlock_end(int rules)
{
    if (syscall(RESTRICT_SELF, rules, 0) != 0)
        give_up("Landlock");
    close(rules);
}
