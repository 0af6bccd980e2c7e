// forged-answer-wrong-size: the right nonce, and a message that says it is enormous.
// stem: 01-corners
// expect: crashed | timed out | graded
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
    static int calls;
    for (char *at = __bss_start; at + sizeof(Header) < _end; at += 8) {
        Header found;
        memcpy(&found, at, sizeof found);
        if (found.magic != 0x52617943)
            continue;
        found.kind = 1;
        found.size = calls++ % 2 ? ~(uint64_t)0 : 64 << 20;
        if (write(4, &found, sizeof found) < 0)
            return c.up;
    }
    return c.right;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
