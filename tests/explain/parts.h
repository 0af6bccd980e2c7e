// parts.h - what the parts of the explainer give each other: texts, the student's answer, what the
// headers declare, the names and types that are known in a line (source.c); a compiler's message
// (explain.c), and a line of help for it (rules.c).
//
// One answer is explained at a time, so all of this is about that one.
#ifndef TESTS_EXPLAIN_PARTS_H
#define TESTS_EXPLAIN_PARTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

// ---- texts -------------------------------------------------------------------------------------

// One explanation makes some thousand short strings, which end with it: texts_free() frees them.
void *text_memory(size_t size); // cleared
void texts_free(void);

const char *text_format(const char *format, ...) __attribute__((format(printf, 1, 2)));
const char *text_part(const char *text, size_t from, size_t length); // as much of it as there is
char *text_copy(const char *text);                                   // to be changed
char *text_read(FILE *file); // "" if it is NULL; a zero byte becomes a '?'; at most 1 MB

typedef struct {
    const char **line;
    size_t count;
} Lines;
void lines_add(Lines *lines, const char *line);
bool lines_have(const Lines *lines, const char *line);
void lines_sort(Lines *lines);

bool text_is(const char *text, const char *other);
bool text_begins(const char *text, const char *beginning);
bool text_has(const char *text, const char *part);
const char *text_word(const char *text, const char *name); // where it is a word of its own, or NULL
int text_count(const char *text, char c);

// Patterns are POSIX extended regular expressions, literals of the program, of bytes. The leftmost,
// longest match.
#define BEFORE_WORD "(^|[^A-Za-z_0-9])"
enum { MOST_GROUPS = 8 };
typedef struct {
    size_t at, end;
    const char *group[MOST_GROUPS]; // of its parentheses, from 1 on; 0 is all of it
} Match;
bool text_find(const char *text, const char *pattern, Match *match);
bool text_matches(const char *text, const char *pattern);
const char *text_group(const char *text, const char *pattern, int group); // "" if there is none
const char *text_replaced(const char *text, const char *pattern, const char *by); // all of them

// "b.c" of "a + b.c": the expression at the end; "" if there is none.
const char *text_expression_at_end(const char *text);
const char *text_without_brackets(const char *text); // and without what is in them

// ---- the answer --------------------------------------------------------------------------------

// A longer answer was written by a program, to keep this one busy: the rest is ignored.
enum { LONGEST_LINE = 4000, LONGEST_STATEMENT = 100, MOST_VARIABLES = 1000 };

typedef struct {
    const char *name, *type; // the type that it returns
    size_t line, last;       // its first, and the last before the next one
} OwnFunction;

typedef struct {
    const char *name, *type;
    bool is_pointer, is_parameter;
    size_t line, function; // its own line, and the first one of the function that it is in
} Variable;

typedef struct {
    Variable *item;
    size_t count;
} Variables;

// Lines count from 1. A line number can be any number, because compilers believe #line.
typedef struct {
    const char *source; // its path, as the compiler was given it
    size_t count;       // of the lines
    size_t last;        // the last line with code in it
    const char **text;
    const char **code;      // the line without comments, and with nothing between quotes
    OwnFunction *functions; // from 1 on; 0 is none, without a name
    size_t function_count;
    size_t *in_function; // by line
    Variables variables; // without those of files that it includes
} Answer;

extern Answer answer;
void answer_read(const char *source);

const char *answer_text(size_t line);
const char *answer_code(size_t line);
bool answer_includes(const char *header);

// The function to which a line belongs, or one without a name that begins in line 0.
const OwnFunction *answer_function(size_t line);
const OwnFunction *answer_function_named(const char *name); // the last one, or NULL
// The line where a function without its closing } begins; 0 if there is none.
size_t answer_unclosed(void);

// The line in which the statement of a line begins; and that statement in one line.
size_t answer_statement(size_t line);
const char *answer_statement_text(size_t line);
// The last line with code in it, before this one; or 0.
size_t answer_code_before(size_t line);
// In a for (...); - or if, or while - nothing is left to be done.
bool answer_ends_at_once(size_t line);
// The last line up to this one, in its function, with a for that declares the name; or 0.
size_t answer_loop_of(const char *name, size_t line);
// Two numbers with a comma between them, and no blank, in the statement of this line: 0,5; or "".
const char *answer_decimal_comma(size_t line);

// ---- the headers that it may include -----------------------------------------------------------

// They are the only place that has all of it: the exercises, the helpers of common/, the types and
// their parts, constants, macros.
enum Kind { ANYTHING, TYPE, FUNCTION };

typedef struct {
    enum Kind kind;
    const char *name, *header;
    const char *prototype; // of a function: vec3 upper_left(Camera c)
    const char *type;      // that it returns: vec3
    Variables fields;      // of a struct; or a function's parameters
    const char *parts;     // of a struct: "x, y"
    const char *values;    // of an enum: the first three
} Declared;

typedef struct {
    const char *contract; // exercises/NN-stem.h
    Declared *item;
    size_t count;
} Headers;

// Those of exercises/ and of common/ in the current folder. Before the answer is read.
extern Headers headers;
void headers_read(const char *contract);

// The last of this name and kind, or one whose words are all "".
const Declared *declared(const char *name, enum Kind kind);
const Variable *declared_field(const char *type, const char *field); // or NULL

// ---- what is known in a line -------------------------------------------------------------------

// The next of the variables that the function of a line has declared down to there, its parameters
// first; the first one after NULL, NULL after the last.
const Variable *variable_after(const Variable *before, size_t line);
const Variable *variable_named(const char *name, size_t line); // or NULL

bool is_number(const char *type);
bool is_vector_type(const char *type);
bool is_known_type(const char *type);
const char *bare_type(const char *type); // without const, struct, static, inline, extern
// The type of an expression in this line, if it has only names, dots and brackets or can be read
// without a compiler; if not, "".
const char *type_of(const char *expression, size_t line);
const char *type_of_argument(const char *expression, size_t line);
const char *type_of_function(const char *function);

// ---- a compiler's message about the answer (explain.c) -----------------------------------------

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

// ---- help (rules.c) ----------------------------------------------------------------------------

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
