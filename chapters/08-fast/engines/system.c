// system.c - memory in large pages.
#include "chapters/08-fast/engines/system.h"

#include "common/large_pages.h"

#include <stdint.h>
#include <stdlib.h>

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
