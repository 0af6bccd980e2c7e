// forged-answer-early: finds the call and its nonce in memory, and answers before it is asked to.
// stem: 01-corners
// expect: crashed | graded
// earns: nothing
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
    vec3 answer = vec3_of(-1, 1, 4);
    for (char *at = __bss_start; at + sizeof(Header) < _end; at += 8) {
        Header found;
        memcpy(&found, at, sizeof found);
        if (found.magic != 0x52617943)
            continue;
        for (int i = 0; i < 9; i++, found.nonce++) {
            found.kind = 1;
            found.size = sizeof answer;
            if (write(4, &found, sizeof found) < 0 || write(4, &answer, sizeof answer) < 0)
                return c.up;
        }
    }
    return answer;
}
