// large_pages.c - long arrays: a hint for the system, and memory for them.
#include "common/large_pages.h"

#include <stdint.h>
#include <stdlib.h>
#ifdef __linux__
#include <sys/mman.h>
#endif

void large_pages(void *memory, size_t size)
{
#ifdef MADV_HUGEPAGE
    const uintptr_t page = 1 << 12, large = 1 << 21;
    // The first and the last page as well: realloc moves an array without copying if all of its
    // pages are of one kind.
    uintptr_t first = (uintptr_t)memory / page * page;
    uintptr_t end = ((uintptr_t)memory + size + page - 1) / page * page;
    if (memory != NULL && size >= large)
        madvise((void *)first, end - first, MADV_HUGEPAGE);
#else
    (void)memory;
    (void)size;
#endif
}

void *large_memory(size_t size)
{
    const size_t line = 64, page = 1 << 21;
    if (size > SIZE_MAX - page)
        return NULL;
    // A quarter of a large page costs less than the small pages.
    const size_t unit = size < page / 4 ? line : page;
    const size_t whole = (size + unit - 1) / unit * unit;
    void *memory = aligned_alloc(unit, whole);
    large_pages(memory, whole);
    return memory;
}
