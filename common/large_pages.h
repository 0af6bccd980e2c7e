// large_pages.h - long arrays: a hint for the system, and memory for them.
#ifndef COMMON_LARGE_PAGES_H
#define COMMON_LARGE_PAGES_H

#include <stddef.h>

// Asks for large pages for memory of malloc, before its first use. The system finds and clears each
// page then, and that is much cheaper with pages of 2 MB than of 4 KB. If there are no large pages,
// or the array is too short for them, nothing changes.
void large_pages(void *memory, size_t size);

// Memory for this many bytes, aligned to a line of the cache, or if it is long to large pages. NULL
// if there is not enough.
void *large_memory(size_t size);

#endif
