// large_memory.h - memory for large arrays, in large pages if the system has them.
#ifndef CHAPTERS_08_FAST_LARGE_MEMORY_H
#define CHAPTERS_08_FAST_LARGE_MEMORY_H

#include <stddef.h>

// Like malloc; free it with free. The memory begins at the start of a cache line. The system finds
// and clears each page of memory at its first use, and that is much cheaper with pages of 2 MB than
// of 4 KB.
void *large_memory(size_t size);

#endif
