// entries.h - lines of KEY tab VALUE: what the judge reports, and the record that is kept of it.
//
// In a value \n, \t and \\ are a line's end, a tab and a backslash, and \xNN is a byte that is not
// printable: a value may be any text, and a line has one.
#ifndef TESTS_COURSE_ENTRIES_H
#define TESTS_COURSE_ENTRIES_H

#include <stdbool.h>
#include <stdio.h>

typedef struct {
    const char *key, *value;
} Entry;

typedef struct {
    char *text; // keys and values are in it
    Entry *entries;
    int count;
} Entries;

// Writes a line, unless the value is NULL or empty.
void entry_put(FILE *out, const char *key, const char *value);

// Reads a file's lines. False if it cannot be read or a line is invalid. Free them in either case.
bool entries_read(const char *path, Entries *entries);
void entries_free(Entries *entries);

// The value of the first of count entries that has this key; "" if there is none.
const char *entry_value(const Entry *entries, int count, const char *key);

#endif
