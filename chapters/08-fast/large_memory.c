// large_memory.c - memory in large pages.
#include "chapters/08-fast/large_memory.h"

#include <stdint.h>
#include <stdlib.h>
#include <sys/mman.h>

void *large_memory(size_t size)
{
    const size_t line = 64, page = 1 << 21;
    if (size > SIZE_MAX - page)
        return NULL;
    const size_t unit = size < page ? line : page;
    void *memory = aligned_alloc(unit, (size + unit - 1) / unit * unit);
#ifdef MADV_HUGEPAGE
    if (memory != NULL && unit == page)
        madvise(memory, size, MADV_HUGEPAGE); // a wish: without it, all is well, too
#endif
    return memory;
}
