// memory-bomb-by-pages: the same past malloc: mmap and brk, its limits raised first.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    enum { USE = PROT_READ | PROT_WRITE, KIND = MAP_PRIVATE | MAP_ANONYMOUS };
    long most = 0;
    setrlimit(RLIMIT_AS, &(struct rlimit){RLIM_INFINITY, RLIM_INFINITY});
    setrlimit(RLIMIT_DATA, &(struct rlimit){RLIM_INFINITY, RLIM_INFINITY});
    for (int i = 0; i < 64; i++) {
        void *pages = mmap(NULL, 16 << 20, USE, KIND, -1, 0);
        void *more = sbrk(1 << 20);
        if (pages != MAP_FAILED)
            memset(pages, 1, 16 << 20), most += 16;
        if (more != (void *)-1)
            memset(more, 1, 1 << 20), most += 1;
    }
    return most > 1000 ? vec3_of(7777, (double)most, 0) : c.up;
}
