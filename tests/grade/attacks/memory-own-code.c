// memory-own-code: makes the answering program's code writable and patches its checks away.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <stdbool.h>
#include <stdint.h>
#include <sys/mman.h>

extern bool wire_is_read(const void *wire) __attribute__((weak));
extern bool dispatch(int exercise, void *in, void *out) __attribute__((weak));

vec3 upper_left(Camera c)
{
    uintptr_t at[] = {(uintptr_t)wire_is_read, (uintptr_t)dispatch};
    for (int i = 0; i < 2; i++) {
        void *page = (void *)(at[i] & ~(uintptr_t)4095);
        if (at[i] != 0 && mprotect(page, 8192, PROT_READ | PROT_WRITE | PROT_EXEC) == 0)
            *(volatile unsigned char *)at[i] = 0xc3; // return
    }
    return c.up;
}
