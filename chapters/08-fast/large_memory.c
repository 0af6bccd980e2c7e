// large_memory.c - memory in large pages.
#include "chapters/08-fast/large_memory.h"

#include <stdint.h>
#include <stdlib.h>
#include <sys/mman.h>

void *large_memory(size_t size)
{
    const size_t page = 1 << 21;
    if (size < page || size > SIZE_MAX - page)
        return malloc(size);
    void *memory = aligned_alloc(page, (size + page - 1) / page * page);
#ifdef MADV_HUGEPAGE
    if (memory != NULL)
        madvise(memory, size, MADV_HUGEPAGE); // a wish: without it, all is well, too
#endif
    return memory;
}
