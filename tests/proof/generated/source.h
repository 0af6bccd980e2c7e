// source.h - preprocessed C as tokens, and what stands at its top level.
#ifndef TESTS_GENERATED_SOURCE_H
#define TESTS_GENERATED_SOURCE_H

#include <stdbool.h>

typedef enum { NAME, NUMBER, STRING, SIGN } Kind;

typedef struct {
    char *text;
    Kind kind;
    int line;
    int item; // what it names at the top level of its source; -1 where nothing
} Token;

// A function, a declaration or a table: its tokens, and its name.
typedef struct {
    const char *name;
    int from, body, to; // body: its {, or 0 where it is no function
} Item;

enum { MOST_TOKENS = 40000, MOST_ITEMS = 800, MOST_ENTRIES = 200 };

// An answer that the source has: a solution, a mistake or a right answer written otherwise.
typedef struct {
    char exercise[64], label[100];
    int item;
} Entry;

typedef struct {
    char path[200];
    Token tokens[MOST_TOKENS];
    int token_count;
    Item items[MOST_ITEMS];
    int item_count;
    Entry entries[MOST_ENTRIES];
    int entry_count;
    bool reaches[MOST_ITEMS][MOST_ITEMS]; // calls, or is, directly or through others
} Source;

// Reads what the preprocessor made. What does not stand in the folders of answers is left out.
void source_read(Source *source, const char *preprocessed);

bool token_is(const Source *source, int i, const char *text);

// Of an opening bracket the closing one, or the other way round.
int matching(const Source *source, int i);

// What has this name at the top level; -1 where nothing.
int item_named(const Source *source, const char *name);

#endif
