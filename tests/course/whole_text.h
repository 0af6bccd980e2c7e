// whole_text.h - a file's bytes in memory, and a number that stands for them.
#ifndef TESTS_COURSE_WHOLE_TEXT_H
#define TESTS_COURSE_WHOLE_TEXT_H

#include <stddef.h>
#include <stdint.h>

// All of a file, with a '\0' after it; free it. NULL if it cannot be read.
char *whole_text(const char *path, size_t *size);

// Texts that differ have different hashes, but for a chance of 1 in 2^64: nobody is attacked by an
// equal one, only mistaken. Begin with HASH_BEGIN, and go on with what came before.
#define HASH_BEGIN 0xcbf29ce484222325u
uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t size);
uint64_t hash_string(uint64_t hash, const char *text);
// Of a file's name and its bytes; of one that is not there, that it is not.
uint64_t hash_file(uint64_t hash, const char *path);

enum { HASH_WORD = 17 };
void hash_word(char word[HASH_WORD], uint64_t hash);

#endif
