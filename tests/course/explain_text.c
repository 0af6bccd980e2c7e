// explain_text.c - strings of the explainer: made, searched, and freed all at once.
#include "tests/course/explain_inside.h"

#include <ctype.h>
#include <regex.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---- memory ------------------------------------------------------------------------------------

typedef struct Block {
    struct Block *next;
    size_t used, size;
    max_align_t memory[];
} Block;

static Block *blocks;

void *text_memory(size_t size)
{
    enum { ORDINARY = 1 << 16 };
    const size_t unit = sizeof(max_align_t);
    if (size > SIZE_MAX / 2)
        abort();
    size = (size + unit - 1) / unit * unit;
    if (blocks == NULL || blocks->size - blocks->used < size) {
        size_t room = size > ORDINARY ? size : ORDINARY;
        Block *block = calloc(1, sizeof *block + room);
        if (block == NULL) {
            fprintf(stderr, "out of memory\n");
            exit(1);
        }
        block->size = room;
        block->next = blocks;
        blocks = block;
    }
    void *memory = (char *)blocks->memory + blocks->used;
    blocks->used += size;
    return memory;
}

void texts_free(void)
{
    while (blocks != NULL) {
        Block *next = blocks->next;
        free(blocks);
        blocks = next;
    }
}

const char *text_format(const char *format, ...)
{
    va_list words, again;
    va_start(words, format);
    va_copy(again, words);
    int length = vsnprintf(NULL, 0, format, words);
    va_end(words);
    char *text = text_memory((size_t)(length < 0 ? 0 : length) + 1);
    if (length > 0)
        vsnprintf(text, (size_t)length + 1, format, again);
    va_end(again);
    return text;
}

const char *text_part(const char *text, size_t from, size_t length)
{
    size_t from_here = strnlen(text, from);
    length = strnlen(text + from_here, length);
    char *part = text_memory(length + 1);
    memcpy(part, text + from_here, length);
    return part;
}

const char *text_from(const char *text, size_t from)
{
    return text + strnlen(text, from);
}

char *text_copy(const char *text)
{
    size_t size = strlen(text) + 1;
    return memcpy(text_memory(size), text, size);
}

char *text_of_file(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL)
        return NULL;
    size_t size = 0, room = 1 << 14;
    char *text = text_memory(room + 1);
    for (size_t more; (more = fread(text + size, 1, room - size, file)) > 0;) {
        size += more;
        if (size == room) {
            char *larger = text_memory(2 * room + 1);
            memcpy(larger, text, size);
            text = larger;
            room *= 2;
        }
    }
    fclose(file);
    for (size_t i = 0; i < size; i++)
        if (text[i] == '\0')
            text[i] = '?';
    return text;
}

char *text_next_line(char **rest)
{
    char *line = *rest;
    if (*line == '\0')
        return NULL;
    char *end = strchr(line, '\n');
    if (end == NULL)
        *rest = line + strlen(line);
    else {
        *end = '\0';
        *rest = end + 1;
    }
    return line;
}

void lines_add(Lines *lines, const char *line)
{
    // Room for 16, and twice as many whenever it is full.
    size_t count = lines->count;
    if (count == 0 || (count >= 16 && (count & (count - 1)) == 0)) {
        const char **larger = text_memory((count == 0 ? 16 : 2 * count) * sizeof *larger);
        if (count > 0)
            memcpy(larger, lines->line, count * sizeof *larger);
        lines->line = larger;
    }
    lines->line[lines->count++] = line;
}

// ---- searching ---------------------------------------------------------------------------------

bool is_word_character(char c)
{
    return isalnum((unsigned char)c) || c == '_';
}

bool text_is(const char *text, const char *other)
{
    return strcmp(text, other) == 0;
}

bool text_is_one_of(const char *text, const char *names)
{
    size_t length = strcspn(text, " ");
    if (text[length] != '\0')
        return false;
    for (const char *at = names; length > 0 && (at = strstr(at, text)) != NULL; at++)
        if ((at == names || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0'))
            return true;
    return false;
}

bool text_begins(const char *text, const char *beginning)
{
    return strncmp(text, beginning, strlen(beginning)) == 0;
}

bool text_has(const char *text, const char *part)
{
    return strstr(text, part) != NULL;
}

bool text_has_word(const char *text, const char *name)
{
    size_t length = text_span_of_word(name);
    if (length == 0 || name[length] != '\0')
        return false;
    for (const char *at = text; (at = strstr(at, name)) != NULL; at++)
        if ((at == text || !is_word_character(at[-1])) && !is_word_character(at[length]))
            return true;
    return false;
}

bool text_says(const char *text, const char *phrases)
{
    for (;;) {
        bool first = phrases[0] == '^';
        phrases += first;
        size_t length = strcspn(phrases, "|");
        for (const char *at = text; *at != '\0'; at++)
            if (strncmp(at, phrases, length) == 0)
                return true;
            else if (first)
                break;
        if (phrases[length] == '\0')
            return false;
        phrases += length + 1;
    }
}

int text_count(const char *text, char c)
{
    int count = 0;
    for (; *text != '\0'; text++)
        count += *text == c;
    return count;
}

size_t text_span(const char *text, const char *set)
{
    return strspn(text, set);
}

size_t text_span_of_word(const char *text)
{
    size_t length = 0;
    while (is_word_character(text[length]))
        length++;
    return length;
}

// ---- patterns ----------------------------------------------------------------------------------

// A pattern is compiled when it is first looked for. Patterns are literals, so that their addresses
// tell them apart.
typedef struct {
    const char *pattern;
    regex_t compiled;
} Pattern;

static const regex_t *compiled(const char *pattern)
{
    enum { ROOM = 512 };
    static Pattern patterns[ROOM];
    size_t i = (uintptr_t)pattern / 8 % ROOM;
    for (size_t tried = 0; tried < ROOM; tried++, i = (i + 1) % ROOM) {
        if (patterns[i].pattern == pattern)
            return &patterns[i].compiled;
        if (patterns[i].pattern == NULL) {
            if (regcomp(&patterns[i].compiled, pattern, REG_EXTENDED) != 0)
                break;
            patterns[i].pattern = pattern;
            return &patterns[i].compiled;
        }
    }
    fprintf(stderr, "not a pattern, or too many: %s\n", pattern);
    abort();
}

static bool find_from(const char *text, size_t from, const char *pattern, Match *match)
{
    regmatch_t found;
    if (regexec(compiled(pattern), text + from, 1, &found, from > 0 ? REG_NOTBOL : 0) != 0)
        return false;
    *match = (Match){from + (size_t)found.rm_so, (size_t)(found.rm_eo - found.rm_so)};
    return true;
}

bool text_matches(const char *text, const char *pattern)
{
    return regexec(compiled(pattern), text, 0, NULL, 0) == 0;
}

bool text_find(const char *text, const char *pattern, Match *match)
{
    return find_from(text, 0, pattern, match);
}

const char *text_group(const char *text, const char *pattern, int group)
{
    enum { MOST_GROUPS = 8 };
    regmatch_t found[MOST_GROUPS];
    if (regexec(compiled(pattern), text, MOST_GROUPS, found, 0) != 0 || found[group].rm_so < 0)
        return "";
    return text_part(text, (size_t)found[group].rm_so,
                     (size_t)(found[group].rm_eo - found[group].rm_so));
}

const char *text_without(const char *text, const char *pattern)
{
    Match match;
    if (!text_find(text, pattern, &match))
        return text;
    return text_format("%.*s%s", (int)match.at, text, text + match.at + match.length);
}

const char *text_replaced(const char *text, const char *pattern, const char *by)
{
    Match match;
    if (!text_find(text, pattern, &match))
        return text;
    size_t length = strlen(text), added = strlen(by), used = 0, from = 0;
    char *replaced = text_memory(length + (length + 1) * added + 1);
    do {
        memcpy(replaced + used, text + from, match.at - from);
        used += match.at - from;
        used = (size_t)(stpcpy(replaced + used, by) - replaced);
        from = match.at + match.length;
    } while (match.length > 0 && from < length && find_from(text, from, pattern, &match));
    memcpy(replaced + used, text + from, length - from + 1);
    return replaced;
}

// A name, and then .name, ->name and [...], back from the end.
const char *text_expression_at_end(const char *text)
{
    return text_group(text, "[A-Za-z_][A-Za-z_0-9]*((\\.|->)[A-Za-z_][A-Za-z_0-9]*|\\[[^]]*\\])*$",
                      0);
}

const char *text_before(const char *text, const char *sign)
{
    const char *at = strstr(text, sign);
    size_t length = at == NULL ? 0 : (size_t)(at - text);
    while (length > 0 && text[length - 1] == ' ')
        length--;
    return text_part(text, 0, length);
}

const char *bare_type(const char *type)
{
    static const char qualifier[] = "(^|[ (*])(const|struct|static|inline|extern) ";
    for (Match match; text_find(type, qualifier, &match);) {
        const char *before = text_group(type, qualifier, 1);
        type = text_format("%.*s%s%s", (int)match.at, type, before, type + match.at + match.length);
    }
    return text_group(type, "[^ ](.*[^ ])?", 0);
}
