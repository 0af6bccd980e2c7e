// large_pages.c - a hint for the system: this array is long.
#include "common/large_pages.h"

#ifdef __linux__
#include <stdint.h>
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
