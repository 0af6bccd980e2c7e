// forged-crash: reports a crash that never was, with a signal and an address of its own making.
// stem: 01-corners
// expect: crashed | graded
// earns: upper_right
#include "exercises/01-corners.h"
#include <stdint.h>
#include <string.h>
#include <unistd.h>

typedef struct {
    uint32_t magic;
    int32_t exercise;
    uint64_t nonce, size;
    int32_t kind;
    char missing[60];
} Header;
extern char __bss_start[], _end[];

vec3 upper_left(Camera c)
{
    struct {
        int32_t signal, access;
        uint64_t address;
        int32_t stack_overflow, out_of_memory;
    } crash = {-2147483647, 1 << 30, ~(uint64_t)0, 0, 0};
    for (char *at = __bss_start; at + sizeof(Header) < _end; at += 8) {
        Header found;
        memcpy(&found, at, sizeof found);
        if (found.magic != 0x52617943)
            continue;
        found.kind = 2;
        found.size = sizeof crash;
        if (write(4, &found, sizeof found) < 0 || write(4, &crash, sizeof crash) < 0)
            return c.up;
    }
    return c.right;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
