// forged-answer-guessed: an answer for the judge's pipe with a nonce that is a guess.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: no answer | was killed | by itself
#include "exercises/01-corners.h"
#include <stdint.h>
#include <unistd.h>

static struct {
    uint32_t magic;
    int32_t exercise;
    uint64_t nonce, size;
    int32_t kind;
    char missing[60];
    vec3 answer;
} message = {.magic = 0x52617943, .nonce = 1, .size = sizeof(vec3), .kind = 1};

vec3 upper_left(Camera c)
{
    message.answer = vec3_of(-1, 1, 4);
    if (write(4, &message, 88) < 0 || write(4, &message.answer, 32) < 0)
        return c.up;
    return c.right;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
