// rules.h - a compiler's message about the student's answer, and a line of help for it.
#ifndef TESTS_EXPLAIN_RULES_H
#define TESTS_EXPLAIN_RULES_H

#include "tests/explain/source.h"

// The text in single quotes: the first, and the second.
#define QUOTED "'([^']*)"
#define SECOND_QUOTED "^[^']*'[^']*'[^']*'([^']*)"
// Of code.
#define AHEAD_OF_EQUALS "^([^=]*[^= ]) *="
// What a compiler writes below the code that it quotes.
#define CARET_LINE "^[ |~]*\\^"

// What a message is about. It can be of several kinds.
enum {
    ANY = 0,
    UNKNOWN_FUNCTION = 1 << 0, // nobody has declared the name
    UNKNOWN_TYPE = 1 << 1,
    UNKNOWN_VARIABLE = 1 << 2,
    UNKNOWN = UNKNOWN_FUNCTION | UNKNOWN_TYPE | UNKNOWN_VARIABLE,
    SLIDES_LETTER = 1 << 3, // the name is a letter of the slides
    OTHER_LETTER = 1 << 4,  // or another letter
    LACKS_CONTRACT = 1 << 5,
    SYNTAX = 1 << 6,
    SEMICOLON = 1 << 7,
    PASTED = 1 << 8,     // a character that is not C
    MISSPELLED = 1 << 9, // a keyword
    MISSING_BRACE = 1 << 10,
    OUTSIDE = 1 << 11, // of every function
    COUNT = 1 << 12,   // of arguments
    ARGUMENT = 1 << 13,
    CONFLICT = 1 << 14, // with another declaration
    STATIC = 1 << 15,   // so is this, but only by that word
    MISSING_RETURN = 1 << 16,
    UNUSED_VALUE = 1 << 17,
    COMMA = 1 << 18,        // the operator
    DECIMAL = 1 << 19,      // comma: 0,5
    ENDS_AT_ONCE = 1 << 20, // a loop
    ARROW = 1 << 21,
    UNTERMINATED = 1 << 22,
    AT_END = 1 << 23,
    VECTOR = 1 << 24,        // where a number is expected
    TYPES = 1 << 25,         // one is expected, and another given
    WANTS_POINTER = 1 << 26, // to the given type
    GIVES_POINTER = 1 << 27, // to the expected type
    WARNING = 1 << 28,
    ERROR = 1 << 29 // and not a missing return or }
};

typedef struct {
    const char *first_line; // FILE:LINE:COLUMN: error: WORDS
    const char *text;       // its words
    const char *name;       // the first of them in quotes
    bool is_warning;
    size_t line, column;
    Lines body;         // the quote, what is below it, and the notes
    const char *ahead;  // the quoted line before the caret, without the margin
    const char *behind; // and from the caret on

    // Of notes about other files.
    const char *library;  // <math.h>
    const char *argument; // "expected 'vec3' but argument is of type 'double'"
    const char *declared; // the function that is called

    unsigned kinds;
    bool is_dropped;            // only follows from another
    const char *code;           // of its line
    size_t begins;              // where its function begins, or 0
    size_t statement;           // and its statement
    const char *translation;    // of a letter of the slides: "d is c.distance"; or ""
    const char *slip;           // perhaps a misspelled keyword,
    const char *keyword;        // and that keyword, or ""
    const char *decimal;        // 0,5 or ""
    const char *declares;       // the name after a misspelled type, or ""
    const char *wanted, *given; // types, or ""
} Mistake;

enum { MOST_READ = 60 }; // the other messages are only counted

typedef struct {
    Mistake mistakes[MOST_READ];
    size_t count, unread;
    const char *elsewhere;      // an error in another file, or ""
    const char *where_included; // "FILE:LINE" of the answer, from which that came; or ""
    Lines raw;                  // whatever else looks like an error
    size_t open_function;       // where the function begins that lacks a }, or 0
} Explanation;

extern Explanation all;

// A line is not wrapped at its blanks.
#define UNBROKEN "\001"

// A line of help, or "".
const char *help(const Mistake *mistake);

// The part of a Camera, Ray, Sphere or Resolution that has this letter on the slides, or "".
const char *part_of_deck(const char *type, const char *letter);
// A letter that nobody declared, by the names of this function: "d is c.distance"; or "". others:
// the letters that mean nothing in it, separated by ", ".
const char *translated(const char *letter, size_t line, const char *others);
// Where in this line a value has a part of this name: "camera.width or view.width", or "". owner:
// their type, "" if there are several.
const char *whole_of(const char *part, size_t line, const char **owner);
// The letters of the mistakes in a function, of the kind: "a, b" or "d is c.distance, w is
// c.width".
const char *letters(unsigned kind, size_t begins);

#endif
