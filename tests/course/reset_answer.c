// reset_answer.c - puts the blank back in the place of an answer.
#include "tests/course/reset_answer.h"

#include "common/whole_file.h"
#include "tests/course/whole_text.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct {
    const char *bytes;
    size_t size;
} Bytes;

static bool write_bytes(FILE *file, const void *given, const char *path, Message *message)
{
    const Bytes *bytes = given;
    if (fwrite(bytes->bytes, 1, bytes->size, file) == bytes->size)
        return true;
    return message_set(message, "%s: cannot be written", path);
}

static bool put(const char *path, const char *bytes, size_t size)
{
    Message message;
    if (file_write_whole(path, write_bytes, &(Bytes){bytes, size}, &message))
        return true;
    fprintf(stderr, "%s\n", message.text);
    return false;
}

static bool keep(const char *answer, const char *text, size_t size)
{
    char kept[4200];
    for (int n = 1;; n++) {
        snprintf(kept, sizeof kept, "%s.backup-%d", answer, n);
        if (access(kept, F_OK) != 0)
            break;
    }
    if (!put(kept, text, size))
        return false;
    printf("Your answer is kept as %s\n", kept);
    return true;
}

int reset_answer(const char *blank, const char *answer)
{
    size_t size, old_size;
    char *text = whole_text(blank, &size), *old = whole_text(answer, &old_size);
    bool good = text != NULL;
    if (!good)
        fprintf(stderr, "%s: cannot be read\n", blank);
    bool is_blank = good && old != NULL && old_size == size && memcmp(old, text, size) == 0;
    if (good && old != NULL && !is_blank)
        good = keep(answer, old, old_size);
    good = good && put(answer, text, size);
    if (good)
        printf("%s is the blank again.\n", answer);
    free(text);
    free(old);
    return good ? 0 : 1;
}
