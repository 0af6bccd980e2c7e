// source.h - the student's answer as text, what the headers declare, and the names and types that
// are known in a line; and the strings that all of it is made of.
//
// One answer is explained at a time, so all of this is about that one.
#ifndef TESTS_EXPLAIN_SOURCE_H
#define TESTS_EXPLAIN_SOURCE_H

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

#endif
