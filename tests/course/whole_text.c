// whole_text.c - a file's bytes in memory, and a number that stands for them.
#include "tests/course/whole_text.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

char *whole_text(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL)
        return NULL;
    size_t room = 1 << 16;
    char *text = malloc(room);
    *size = 0;
    while (text != NULL) {
        *size += fread(text + *size, 1, room - 1 - *size, file);
        if (*size < room - 1)
            break;
        char *larger = realloc(text, room *= 2);
        if (larger == NULL)
            free(text);
        text = larger;
    }
    if (ferror(file)) {
        free(text);
        text = NULL;
    }
    fclose(file);
    if (text != NULL)
        text[*size] = '\0';
    return text;
}

// Eight bytes at a time, since judges are megabytes: a multiplication spreads each word to the
// higher bits, and the shift brings those back down (the finish of MurmurHash3).
static uint64_t mix(uint64_t hash, uint64_t word)
{
    hash = (hash ^ word) * 0xff51afd7ed558ccdu;
    return hash ^ (hash >> 32);
}

uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t size)
{
    const char *from = bytes;
    hash = mix(hash, size);
    for (; size >= sizeof hash; from += sizeof hash, size -= sizeof hash) {
        uint64_t word;
        memcpy(&word, from, sizeof word);
        hash = mix(hash, word);
    }
    uint64_t rest = 0;
    memcpy(&rest, from, size);
    return mix(hash, rest);
}

uint64_t hash_string(uint64_t hash, const char *text)
{
    return hash_bytes(hash, text, strlen(text));
}

uint64_t hash_file(uint64_t hash, const char *path)
{
    size_t size;
    char *text = whole_text(path, &size);
    hash = hash_string(hash, path);
    hash = text != NULL ? hash_bytes(hash, text, size) : hash_string(hash, "not there");
    free(text);
    return hash;
}

void hash_word(char word[HASH_WORD], uint64_t hash)
{
    snprintf(word, HASH_WORD, "%016" PRIx64, hash);
}
