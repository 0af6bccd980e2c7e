// source.h - preprocessed C as tokens, and the items at its top level.
#ifndef TESTS_GENERATED_SOURCE_H
#define TESTS_GENERATED_SOURCE_H

#include <stdbool.h>

typedef enum { NAME, NUMBER, STRING, SIGN } Kind;

typedef struct {
    char *text;
    Kind kind;
    int line;
    int item; // the item at the top level of its source that it names; or -1
} Token;

// A function, a declaration or a table: its tokens, and its name.
typedef struct {
    const char *name;
    int from, body, to; // body: its {, or 0 if it is not a function
} Item;

enum { MOST_TOKENS = 40000, MOST_ITEMS = 800, MOST_ENTRIES = 200 };

// An answer of the source: a solution, a mistake or a variant of the right answer.
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

// Reads the preprocessor's output. Code from outside the folders of answers is left out.
void source_read(Source *source, const char *preprocessed);

bool token_is(const Source *source, int i, const char *text);

// The closing bracket of an opening one, or the other way round.
int matching(const Source *source, int i);

// The item of this name at the top level; or -1.
int item_named(const Source *source, const char *name);

#endif
