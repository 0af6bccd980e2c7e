// chapter_record.c - the verdict on one chapter: written once, read by every program that shows or
// uses it.
#include "tests/course/chapter_record.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// ---- a file's bytes in memory, and a number that stands for them -------------------------------

char *whole_text(const char *path, size_t *size)
{
    struct stat about;
    FILE *file = fopen(path, "rb");
    if (file == NULL)
        return NULL;
    bool is_there = fstat(fileno(file), &about) == 0 && S_ISREG(about.st_mode);
    char *text = is_there ? malloc((size_t)about.st_size + 1) : NULL;
    if (text != NULL) {
        *size = fread(text, 1, (size_t)about.st_size, file);
        text[*size] = '\0';
    }
    fclose(file);
    return text;
}

// FNV-1a, with the size first, so that two texts are not one.
static uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t size)
{
    const unsigned char *byte = bytes;
    hash = (hash ^ size) * 0x100000001b3u;
    for (size_t i = 0; i < size; i++)
        hash = (hash ^ byte[i]) * 0x100000001b3u;
    return hash;
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

// ---- lines of KEY tab VALUE --------------------------------------------------------------------

void entry_put(FILE *out, const char *key, const char *value)
{
    if (value == NULL || value[0] == '\0')
        return;
    fprintf(out, "%s\t", key);
    for (const char *c = value; *c != '\0'; c++) {
        if (*c == '\n' || *c == '\t' || *c == '\\')
            fprintf(out, "\\%c", *c == '\n' ? 'n' : *c == '\t' ? 't' : '\\');
        else if (*c >= ' ' && *c < 127)
            putc(*c, out);
        else
            fprintf(out, "\\x%02x", (unsigned char)*c);
    }
    putc('\n', out);
}

static int hex_digit(char c)
{
    return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

// In place, which never needs more room. False if a \ is followed by what entry_put does not write.
static bool decode(char *value)
{
    char *to = value;
    for (const char *from = value; *from != '\0';) {
        if (*from != '\\') {
            *to++ = *from++;
        } else if (from[1] == 'n' || from[1] == 't' || from[1] == '\\') {
            *to++ = from[1] == 'n' ? '\n' : from[1] == 't' ? '\t' : '\\';
            from += 2;
        } else if (from[1] == 'x' && hex_digit(from[2]) >= 0 && hex_digit(from[3]) >= 0) {
            *to++ = (char)(hex_digit(from[2]) * 16 + hex_digit(from[3]));
            from += 4;
        } else {
            return false;
        }
    }
    *to = '\0';
    return true;
}

bool entries_read(const char *path, Entries *entries)
{
    size_t size;
    *entries = (Entries){.text = whole_text(path, &size)};
    if (entries->text == NULL || memchr(entries->text, '\0', size) != NULL)
        return false;
    int lines = 0;
    for (const char *c = entries->text; *c != '\0'; c++)
        lines += *c == '\n';
    entries->entries = calloc((size_t)lines + 1, sizeof *entries->entries);
    if (entries->entries == NULL)
        return false;
    for (char *line = entries->text; *line != '\0';) {
        char *end = strchr(line, '\n'), *tab = strchr(line, '\t');
        if (end == NULL || tab == NULL || tab > end)
            return false;
        *end = *tab = '\0';
        if (!decode(tab + 1))
            return false;
        entries->entries[entries->count++] = (Entry){line, tab + 1};
        line = end + 1;
    }
    return true;
}

void entries_free(Entries *entries)
{
    free(entries->text);
    free(entries->entries);
    *entries = (Entries){0};
}

const char *entry_value(const Entry *entries, int count, const char *key)
{
    for (int i = 0; i < count; i++)
        if (strcmp(entries[i].key, key) == 0)
            return entries[i].value;
    return "";
}

// ---- the record --------------------------------------------------------------------------------

static bool find_functions(ChapterRecord *record)
{
    record->head = record->all.count;
    for (int i = 0; i < record->all.count; i++) {
        const Entry *entry = &record->all.entries[i];
        if (strcmp(entry->key, "function") != 0) {
            if (record->function_count > 0)
                record->functions[record->function_count - 1].count++;
            continue;
        }
        if (record->function_count == MOST_FUNCTIONS)
            return false;
        if (record->function_count == 0)
            record->head = i;
        record->functions[record->function_count++] = (FunctionRecord){entry->value, entry + 1, 0};
    }
    return true;
}

bool record_read(const char *path, ChapterRecord *record)
{
    return report_read(path, record) && strcmp(record_value(record, "record"), "1") == 0 &&
           strcmp(record->all.entries[record->all.count - 1].key, "end") == 0;
}

bool report_read(const char *path, ChapterRecord *report)
{
    *report = (ChapterRecord){0};
    return entries_read(path, &report->all) && find_functions(report);
}

void chapter_record_free(ChapterRecord *record)
{
    entries_free(&record->all);
    *record = (ChapterRecord){0};
}

const char *record_value(const ChapterRecord *record, const char *key)
{
    return entry_value(record->all.entries, record->head, key);
}

const char *function_value(const FunctionRecord *function, const char *key)
{
    return entry_value(function->entries, function->count, key);
}

const FunctionRecord *record_function(const ChapterRecord *record, const char *name)
{
    for (int i = 0; i < record->function_count; i++)
        if (strcmp(record->functions[i].name, name) == 0)
            return &record->functions[i];
    return NULL;
}

const char *function_state(const FunctionRecord *function)
{
    const char *state = function_value(function, "state");
    if (function_value(function, "waits")[0] != '\0')
        return "waiting";
    return strcmp(state, "crashed") == 0 || strcmp(state, "timed out") == 0 ? "wrong" : state;
}

bool function_is(const FunctionRecord *function, const char *state)
{
    return strcmp(function_state(function), state) == 0;
}

int functions_that_are(const ChapterRecord *record, const char *state)
{
    int count = 0;
    for (int i = 0; i < record->function_count; i++)
        count += function_is(&record->functions[i], state);
    return count;
}

const FunctionRecord *first_that_is(const ChapterRecord *record, const char *state)
{
    for (int i = 0; i < record->function_count; i++)
        if (function_is(&record->functions[i], state))
            return &record->functions[i];
    return NULL;
}

const char *function_because(const FunctionRecord *function)
{
    const char *waits = function_value(function, "waits");
    return waits[0] != '\0' ? waits
           : strcmp(function_value(function, "state"), "waiting") == 0
               ? function_value(function, "missing")
               : "";
}

// Wrong also if all that is wrong waits for an earlier chapter.
const char *record_state(const ChapterRecord *record)
{
    const char *state = record_value(record, "state");
    bool is_wrong = first_that_is(record, "wrong") != NULL;
    for (int i = 0; i < record->function_count; i++)
        is_wrong = is_wrong || function_value(&record->functions[i], "waits")[0] != '\0';
    int right = functions_that_are(record, "right");
    if (strcmp(state, "judged") != 0)
        return state;
    return right == record->function_count && right > 0 ? "right"
           : is_wrong                                   ? "wrong"
           : right > 0                                  ? "begun"
                                                        : "blank";
}

enum { MOST_PATH = 4096 };

FILE *record_begin(const char *path)
{
    char new[MOST_PATH];
    bool fits = snprintf(new, sizeof new, "%s.new", path) < MOST_PATH && path[0] != '\0';
    return fits ? fopen(new, "w") : NULL;
}

bool record_finish(FILE *file, const char *path)
{
    char new[MOST_PATH];
    snprintf(new, sizeof new, "%s.new", path);
    entry_put(file, "end", "of the record");
    bool good = ferror(file) == 0;
    good = fclose(file) == 0 && good && rename(new, path) == 0;
    if (!good)
        unlink(new);
    return good;
}

// ---- which answers fail perhaps only because of others -----------------------------------------

bool names_include(const char *names, const char *name)
{
    size_t length = strlen(name);
    for (const char *word = names + strspn(names, " "); *word != '\0'; word += strspn(word, " ")) {
        size_t size = strcspn(word, " ");
        if (size == length && strncmp(word, name, length) == 0)
            return true;
        word += size;
    }
    return false;
}

bool names_add(char *names, size_t size, const char *more)
{
    bool any = false;
    for (const char *word = more + strspn(more, " "); *word != '\0'; word += strspn(word, " ")) {
        char name[200];
        size_t length = strlen(names), of_word = strcspn(word, " ");
        snprintf(name, sizeof name, "%.*s", (int)of_word, word);
        word += of_word;
        if (names_include(names, name) || length + of_word + 2 > size)
            continue;
        snprintf(names + length, size - length, "%s%s", length > 0 ? " " : "", name);
        any = true;
    }
    return any;
}

void names_that_may_excuse(const ChapterRecord *record, const FunctionRecord *wrong,
                           char names[MOST_NAMES])
{
    names[0] = '\0';
    const char *calls = function_value(wrong, "calls");
    for (int i = 0; i < record->function_count; i++) {
        const FunctionRecord *other = &record->functions[i];
        if (other != wrong && !function_is(other, "right") && names_include(calls, other->name) &&
            !names_include(function_value(other, "calls"), wrong->name))
            names_add(names, MOST_NAMES, other->name);
    }
}

void put_names(char *list, size_t size, const char *names)
{
    size_t length = 0;
    for (const char *c = names + strspn(names, " "); *c != '\0' && length + 3 < size; c++) {
        if (*c == ' ')
            list[length++] = ',';
        list[length++] = *c;
    }
    list[length] = '\0';
}
