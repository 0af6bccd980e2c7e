// landlock.c - Landlock's rules, by its system calls: the C library has no names for them.
#define _GNU_SOURCE
#include "tests/grading/confine/landlock.h"

#include "tests/grading/confine/give_up.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <stdint.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

// Newer kernels know more rights than the headers that this was compiled with.
struct rights {
    uint64_t files, network, scoped;
};
enum {
    EXECUTE = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE,
    READ = EXECUTE | LANDLOCK_ACCESS_FS_READ_DIR,
    ALL_1 = (1 << 13) - 1, // of version 1
    REFER = 1 << 13,       // 2
    TRUNCATE = 1 << 14,    // 3
    NETWORK = 3,           // 4: bind, connect
    IOCTL = 1 << 15,       // 5
    SCOPED = 3,            // 6: abstract sockets, signals
};

int landlock_version(void)
{
    long version = syscall(SYS_landlock_create_ruleset, NULL, 0, LANDLOCK_CREATE_RULESET_VERSION);
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
    long rules = syscall(SYS_landlock_create_ruleset, &rights, size, 0);
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
        rights &= EXECUTE | LANDLOCK_ACCESS_FS_WRITE_FILE | TRUNCATE | IOCTL;
    struct landlock_path_beneath_attr rule = {rights, place};
    if (syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) != 0)
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
    if (syscall(SYS_landlock_restrict_self, rules, 0) != 0)
        give_up("Landlock");
    close(rules);
}
