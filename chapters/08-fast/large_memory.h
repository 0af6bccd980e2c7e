// large_memory.h - memory for large arrays, in large pages where the system has them.
#ifndef CHAPTERS_08_FAST_LARGE_MEMORY_H
#define CHAPTERS_08_FAST_LARGE_MEMORY_H

#include <stddef.h>

// As malloc, to be freed with free; it begins where a line of the cache does. Memory comes in
// pages, each found and cleared at its first use: in pages of 2 MB instead of 4 KB that is a good
// deal cheaper.
void *large_memory(size_t size);

#endif
