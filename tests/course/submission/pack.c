// pack.c - make submission: the answers of a folder in one archive, and what they lack.
//
// Usage: pack ARCHIVE.zip ANSWERS BLANKS STEM...
// Packs ANSWERS/STEM.c for each stem, and names the chapters that are missing or not answered. The
// exit status is 0 if the archive was written, whatever its answers are.
#include "common/text.h"
#include "common/whole_file.h"
#include "tests/course/submission/stored_zip.h"

#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { LARGEST = 256 * 1024 }; // the grader reads no larger answer (tests/grade/collect/answers.py)

// ---- reading ----------------------------------------------------------------------------------

static char *path_of(const char *folder, const char *name)
{
    size_t length = strlen(folder) + strlen(name) + 2;
    char *path = malloc(length);
    if (path != NULL)
        snprintf(path, length, "%s/%s", folder, name);
    return path;
}

// The bytes of a file, with a zero after them; NULL, and errno, if it cannot be read.
static char *read_file(const char *folder, const char *name, size_t *length)
{
    char *path = path_of(folder, name), *bytes = malloc(LARGEST + 2);
    FILE *file = path == NULL ? NULL : fopen(path, "rb");
    free(path);
    bool read = false;
    if (file != NULL && bytes != NULL) {
        *length = fread(bytes, 1, LARGEST + 1, file);
        bytes[*length] = '\0';
        read = !ferror(file);
    }
    int why = errno;
    if (file != NULL)
        fclose(file);
    if (!read) {
        free(bytes);
        bytes = NULL;
    }
    errno = why;
    return bytes;
}

// ---- what an answer lacks ---------------------------------------------------------------------

static bool is_after_slashes(const char *text, const char *place)
{
    const char *line = place;
    while (line > text && line[-1] != '\n')
        line--;
    const char *slashes = strstr(line, "//");
    return slashes != NULL && slashes < place;
}

// How many functions of a file are blank: each says so once (common/answers.h).
static int blanks_in(const char *text)
{
    static const char word[] = "NOT_ANSWERED";
    int count = 0;
    for (const char *p = text; (p = strstr(p, word)) != NULL; p += sizeof word - 1)
        if ((p == text || !(isalnum((unsigned char)p[-1]) || p[-1] == '_')) &&
            !is_after_slashes(text, p))
            count++;
    return count;
}

typedef struct {
    ZipMember *members;
    size_t count;
    int chapters_open; // missing, blank, or answered in part
} Packed;

static void say(Packed *packed, const char *name, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static void say(Packed *packed, const char *name, const char *format, ...)
{
    printf("  %-20s ", name);
    va_list arguments;
    va_start(arguments, format);
    vprintf(format, arguments);
    va_end(arguments);
    printf("\n");
    packed->chapters_open++;
}

// False if the file is there and cannot be packed.
static bool pack(Packed *packed, const char *answers, const char *blanks, const char *name)
{
    size_t length = 0, blank_length = 0;
    char *text = read_file(answers, name, &length);
    if (text == NULL && errno == ENOENT) {
        say(packed, name, "missing: there is no %s/%s", answers, name);
        return true;
    }
    if (text == NULL) {
        fprintf(stderr, "%s/%s: %s\n", answers, name, strerror(errno));
        return false;
    }
    if (length > LARGEST) {
        fprintf(stderr, "%s/%s: larger than %d KB, which the grader does not read\n", answers, name,
                LARGEST / 1024);
        free(text);
        return false;
    }
    char *blank = read_file(blanks, name, &blank_length);
    int asked = blank == NULL ? 0 : blanks_in(blank), left = blanks_in(text);
    free(blank);
    if (left > 0 && left >= asked)
        say(packed, name, "still blank");
    else if (left > 0)
        say(packed, name, "%d of %d functions not answered yet", left, asked);
    else
        printf("  %s\n", name);
    packed->members[packed->count++] = (ZipMember){name, text, length};
    return true;
}

// ---- the archive ------------------------------------------------------------------------------

static bool write_archive(FILE *file, const void *given, const char *path, Message *message)
{
    const Packed *packed = given;
    zip_write(file, packed->members, packed->count);
    if (ferror(file))
        return message_set(message, "%s: %s", path, strerror(errno));
    return true;
}

// Writes the archive, and prints its name and how many chapters are not finished. The exit status.
static int hand_over(const char *archive, const Packed *packed)
{
    Message message;
    if (packed->count == 0) {
        fprintf(stderr, "There is no answer to hand in.\n");
        return 1;
    }
    if (!file_write_whole(archive, write_archive, packed, &message)) {
        fprintf(stderr, "%s\n", message.text);
        return 1;
    }
    if (packed->chapters_open > 0)
        printf("Not finished: %d of the chapters, see above.\n", packed->chapters_open);
    printf("Hand in this file: %s (%d files)\n", archive, (int)packed->count);
    return fflush(stdout) == 0 ? 0 : 1;
}

int main(int argc, char **argv)
{
    if (argc < 5) {
        fprintf(stderr, "Usage: pack ARCHIVE.zip ANSWERS BLANKS STEM...\n");
        return 2;
    }
    int count = argc - 4, status = 0;
    Packed packed = {calloc((size_t)count, sizeof(ZipMember)), 0, 0};
    char **names = calloc((size_t)count, sizeof *names);
    bool room = packed.members != NULL && names != NULL;
    printf("From %s/:\n", argv[2]);
    for (int i = 0; i < count && room; i++) {
        size_t length = strlen(argv[4 + i]) + 3;
        names[i] = malloc(length);
        room = names[i] != NULL;
        if (room)
            snprintf(names[i], length, "%s.c", argv[4 + i]);
        if (room && !pack(&packed, argv[2], argv[3], names[i]))
            status = 1;
    }
    if (!room) {
        fprintf(stderr, "no memory\n");
        status = 1;
    }
    if (status == 0)
        status = hand_over(argv[1], &packed);
    for (size_t i = 0; i < packed.count; i++)
        free(packed.members[i].bytes);
    for (int i = 0; i < count && names != NULL; i++)
        free(names[i]);
    free(packed.members);
    free(names);
    return status;
}
