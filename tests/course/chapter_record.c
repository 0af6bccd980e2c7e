// chapter_record.c - the verdict on one chapter: written once, read by every program that shows or
// uses it.
#include "tests/course/chapter_record.h"

#include "tests/course/whole_text.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MOST_PATH = 4096 };

static bool record_path(char path[MOST_PATH], const char *folder, const char *stem,
                        const char *ending)
{
    return snprintf(path, MOST_PATH, "%s/%s.record%s", folder, stem, ending) < MOST_PATH;
}

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

// The last line is the hash of those above, which are as they were when the file was complete.
static bool is_whole(const char *path)
{
    size_t size;
    char *text = whole_text(path, &size);
    char word[HASH_WORD], last[HASH_WORD + 8];
    bool good = false;
    int length = snprintf(last, sizeof last, "end\t%*s\n", HASH_WORD - 1, "");
    if (text != NULL && size >= (size_t)length) {
        hash_word(word, hash_bytes(HASH_BEGIN, text, size - (size_t)length));
        snprintf(last, sizeof last, "end\t%s\n", word);
        good = memcmp(text + size - (size_t)length, last, (size_t)length) == 0;
    }
    free(text);
    return good;
}

bool record_read(const char *path, ChapterRecord *record)
{
    *record = (ChapterRecord){0};
    return is_whole(path) && report_read(path, record) &&
           strcmp(record_value(record, "record"), "1") == 0;
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
    if (function_value(function, "unsure")[0] != '\0')
        return "unsure";
    return strcmp(state, "crashed") == 0 || strcmp(state, "timed out") == 0 ? "wrong" : state;
}

const char *function_because(const FunctionRecord *function)
{
    const char *waits = function_value(function, "waits");
    const char *unsure = function_value(function, "unsure");
    return waits[0] != '\0'    ? waits
           : unsure[0] != '\0' ? unsure
           : strcmp(function_value(function, "state"), "waiting") == 0
               ? function_value(function, "missing")
               : "";
}

const char *record_state(const ChapterRecord *record)
{
    const char *state = record_value(record, "state");
    int right = 0, wrong = 0;
    if (strcmp(state, "judged") != 0)
        return state;
    for (int i = 0; i < record->function_count; i++) {
        const char *is = function_state(&record->functions[i]);
        right += strcmp(is, "right") == 0;
        wrong += strcmp(is, "wrong") == 0 || strcmp(is, "unsure") == 0;
    }
    return right == record->function_count && right > 0 ? "right"
           : wrong > 0                                  ? "wrong"
           : right > 0                                  ? "begun"
                                                        : "blank";
}

FILE *record_begin(const char *folder, const char *stem)
{
    char path[MOST_PATH];
    return record_path(path, folder, stem, ".new") ? fopen(path, "w+") : NULL;
}

bool record_finish(FILE *file, const char *folder, const char *stem)
{
    char path[MOST_PATH], new[MOST_PATH], word[HASH_WORD];
    if (!record_path(path, folder, stem, "") || !record_path(new, folder, stem, ".new"))
        return false;
    size_t size = 0;
    char *text = fflush(file) == 0 ? whole_text(new, &size) : NULL;
    if (text != NULL) {
        hash_word(word, hash_bytes(HASH_BEGIN, text, size));
        entry_put(file, "end", word);
    }
    free(text);
    bool good = text != NULL && ferror(file) == 0;
    good = fclose(file) == 0 && good && rename(new, path) == 0;
    if (!good)
        unlink(new);
    return good;
}
