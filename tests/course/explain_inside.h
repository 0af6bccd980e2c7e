// explain_inside.h - the parts of the explainer: texts, the answer and what it may use, and the
// compiler's messages.
//
// One answer is explained at a time, so all of this is about that one.
#ifndef TESTS_COURSE_EXPLAIN_INSIDE_H
#define TESTS_COURSE_EXPLAIN_INSIDE_H

#include <stdbool.h>
#include <stddef.h>

// ---- texts (explain_text.c) --------------------------------------------------------------------

// One explanation makes some hundred short strings, which end with it: texts_free() frees them.
// Positions count from 0.

// Memory that is cleared; grown keeps the old contents.
void *text_memory(size_t size);
void texts_free(void);

const char *text_format(const char *format, ...) __attribute__((format(printf, 1, 2)));
const char *text_part(const char *text, size_t from, size_t length); // as much of it as there is
const char *text_from(const char *text, size_t from);
char *text_copy(const char *text); // to be changed

// The whole file, or NULL; a zero byte in it becomes a '?'.
char *text_of_file(const char *path);
// Cuts the line off the front of *rest; NULL when nothing is left.
char *text_next_line(char **rest);

typedef struct {
    const char **line;
    size_t count;
} Lines;
void lines_add(Lines *lines, const char *line);

bool is_word_character(char c);
bool text_is(const char *text, const char *other);
bool text_is_one_of(const char *text, const char *names); // separated by blanks
bool text_begins(const char *text, const char *beginning);
bool text_has(const char *text, const char *part);
// The name as a word of its own. False if it is not a name.
bool text_has_word(const char *text, const char *name);
// Whether it has one of these phrases, separated by '|'; with '^' in front, at its beginning.
bool text_says(const char *text, const char *phrases);
// How many of this character.
int text_count(const char *text, char c);
// How many characters at the beginning are of this set.
size_t text_span(const char *text, const char *set);
size_t text_span_of_word(const char *text);

// Patterns are POSIX extended regular expressions, literals of the program, of bytes. The leftmost,
// longest match.
typedef struct {
    size_t at, length;
} Match;
bool text_matches(const char *text, const char *pattern);
bool text_find(const char *text, const char *pattern, Match *match);
// What a pair of parentheses of the pattern has found, counted from 1; 0 is all of it. "" if the
// pattern is not there.
const char *text_group(const char *text, const char *pattern, int group);
const char *text_without(const char *text, const char *pattern);                  // the first match
const char *text_replaced(const char *text, const char *pattern, const char *by); // all of them

// "b.c" of "a + b.c": the expression at the end; "" if there is none.
const char *text_expression_at_end(const char *text);
// The text before the first of this sign, without blanks at its end; "" if the sign is missing.
const char *text_before(const char *text, const char *sign);
// A type without const, struct, static, inline, extern, and blanks around it.
const char *bare_type(const char *type);

// ---- the answer, and what it may use (explain_scope.c) -----------------------------------------

typedef struct {
    const char *name;
    const char *type; // what it gives
    size_t line;
} OwnFunction;

// A longer answer was written by a program, to keep this one busy: the rest is ignored.
enum {
    LONGEST_CODE = 4000,
    LONGEST_STATEMENT = 100,
    LONGEST_FUNCTION = 2000
}; // lines, but the first

// Lines count from 1. A line number can be any number, because compilers believe #line.
typedef struct {
    const char *source; // its path, as the compiler was given it
    size_t count;       // of the lines
    size_t last;        // the last line with code in it
    const char **text;
    const char **code; // the line without comments, and with nothing between quotes
    OwnFunction *functions;
    size_t function_count;
    Lines included; // by #include "..."
} Answer;

extern Answer answer;
void answer_read(const char *source);

const char *answer_text(size_t line);
const char *answer_code(size_t line);
bool answer_includes(const char *header);

// The function whose first line it is, or NULL; the last one of this name.
const OwnFunction *answer_function_at(size_t line);
const OwnFunction *answer_function_named(const char *name);
// The line in which the function begins to which this line belongs; 0 if there is none.
size_t answer_beginning(size_t line);
// Its name, or "".
const char *answer_function_around(size_t line);
// The line where a function without its closing } begins; 0 if there is none.
size_t answer_unclosed(void);

// The line in which the statement begins to which this line belongs; and that statement in one
// line.
size_t answer_statement(size_t line);
const char *answer_statement_text(size_t line);
// The last line with code in it, before this one; or 0.
size_t answer_code_before(size_t line);
// How many more ( than ) the statement of this line has.
int answer_brackets(size_t line);

// In a for (...); - or if, or while - nothing is left to be done.
bool answer_ends_at_once(size_t line);
// The last line up to this one, in its function, with a for that declares the name; or 0.
size_t answer_loop_of(const char *name, size_t line);
// Two numbers with a comma between them, and no blank, in the statement of this line: 0,5; or "".
const char *answer_decimal_comma(size_t line);

// The headers themselves are the only place that has all of it: the exercises, the helpers of
// common/, the types and their parts, constants, macros.

typedef struct {
    const char *name, *type;
    bool is_pointer;
} Field;

typedef struct {
    const char *name, *header;
    Field *fields; // of a struct
    size_t field_count;
    const char *parts;  // "x, y"; "" if it is not a struct
    const char *values; // of an enum: the first three
} DeclaredType;

typedef struct {
    const char *name, *header;
    const char *prototype; // vec3 upper_left(Camera c)
    const char *arguments; // (Camera c)
    const char *type;      // vec3
} DeclaredFunction;

typedef struct {
    const char *name, *header;
} DeclaredName;

typedef struct {
    const char *contract; // exercises/NN-stem.h
    DeclaredName *names;  // of all kinds
    size_t name_count, name_room;
    DeclaredType *types;
    size_t type_count, type_room;
    DeclaredFunction *functions;
    size_t function_count, function_room;
} Headers;

// Those of exercises/ and of common/ in the current folder.
extern Headers headers;
void headers_read(const char *contract);

// The header that declares it, or NULL.
const char *header_of(const char *name);
// A name that differs only in its capitals: of a type, or of a constant; NULL if there is none. Of
// the exercises' headers, those up to the contract are looked into.
const DeclaredName *header_name_like(const char *name, bool is_type);
const DeclaredFunction *header_function(const char *name);

// A struct's parts, "" if it is not a struct; its field, or NULL; an enum's values, or "".
const char *header_parts(const char *type);
const Field *header_field(const char *type, const char *field);
const char *header_values(const char *type);

// The types of a prototype's parameters, without const and *.
Lines header_parameter_types(const char *arguments);

typedef struct {
    const char *name, *type;
    bool is_pointer;
} Variable;

// The parameters of the function of a line, and the variables that it declares down to there.
typedef struct {
    Variable *variables;
    size_t count;
    size_t parameters; // the first of them
} Scope;

Scope scope_of(size_t line);

bool is_number(const char *type);
bool is_vector_type(const char *type);
const char *with_article(const char *type); // a Camera, an int

// The type of an expression in this line, if it has only names, dots and brackets or can be read
// without a compiler; if not, "".
const char *type_of(const char *expression, size_t line);
const char *type_of_argument(const char *expression, size_t line);
const char *function_type(const char *function);

// The text without everything in brackets, innermost first.
const char *without_brackets(const char *text);

// How a value of a type is written, or "". A line is not wrapped at its blanks (UNBROKEN).
#define UNBROKEN "\001"
const char *written(const char *type);

// Whether this begins with a declaration: a type, blanks, a name.
bool begins_declaration(const char *text);

// The part of a Camera, Ray, Sphere or Resolution that has this letter on the slides, or "".
const char *part_of_deck(const char *type, const char *letter);
// A letter that nobody declared, by the names of this function: "d is c.distance"; or "". others:
// the letters that mean nothing in it, separated by ", ".
const char *translated(const char *letter, size_t line, const char *others);

// Where in this line a value has a part of this name: "camera.width or view.width", or "". owner:
// their type, "" if there are several.
const char *whole_of(const char *part, size_t line, const char **owner);

// ---- the compiler's messages (explain_mistakes.c) ----------------------------------------------

// Read from the text that gcc and clang write for people, not from JSON or SARIF: the head of a
// message, FILE:LINE:COLUMN: error: WORDS, and the quote below it have been the same in all
// versions of both, and the quote is shown as it is. gcc's JSON leaves the quote out and goes away
// with gcc 15; SARIF needs gcc 13 or clang 15; clang 14 has neither.

typedef struct {
    const char *line; // the whole first line
    const char *text; // its words
    bool is_warning;
    size_t line_number, column;
    Lines body;              // the quote, what is below it, and the notes
    const char *quoted_line; // "" if there is none
    const char *ahead;       // the quoted line before the caret, without the margin
    const char *behind;      // and from the caret on

    // Of notes about other files.
    const char *library;  // <math.h>
    const char *argument; // "expected 'vec3' but argument is of type 'double'"
    const char *declared; // the function that is called
} Message;

// The text in single quotes: the first, or the second; "" if there is none.
const char *quoted(const char *text);
const char *quoted_second(const char *text);
bool is_caret_line(const char *line);

typedef struct {
    const Message *message;
    const char *text; // the message's words
    const char *code; // of its line
    size_t line;
    size_t begins;    // where its function begins, or 0
    size_t statement; // and its statement
    const char *name; // the first in quotes

    bool is_dropped;         // only follows from another
    bool is_unknown;         // nobody has declared the name
    bool is_letter;          // a letter of the slides, perhaps
    const char *translation; // of that letter, or ""
    bool lacks_contract;     // the #include of the chapter is missing
    bool is_pasted;          // a character that is not C
    const char *slip;        // perhaps a misspelled keyword,
    const char *keyword;     // and that keyword, or ""
    bool is_syntax;
    bool is_count; // of arguments
    bool is_signature;
    bool is_missing_return, is_missing_brace;
    bool is_outside; // of every function
    bool is_unused_value;
    bool is_comma;              // the operator
    const char *decimal;        // 0,5 or ""
    const char *declares;       // the name after a misspelled type, or ""
    const char *wanted, *given; // types, or ""
} Mistake;

// Facts about a function, by the line in which it begins: 0 for code outside of all functions.
typedef struct {
    const char *letters;         // that mean something: "d is c.distance, f is c.forward"
    const char *strange_letters; // and that do not: "a, b"
    size_t lost;                 // the line whose value is not used, or 0
} AboutFunction;

enum {
    MOST_SHOWN = 3,
    MOST_READ = 60, // the other messages are only counted
    LONGEST_LINE = 4000
};

typedef struct {
    Message messages[MOST_READ];
    Mistake mistakes[MOST_READ]; // a message each
    size_t count, unread;
    const char *elsewhere;       // an error in another file, or ""
    const char *where_included;  // "FILE:LINE" of the answer, from which that came; or ""
    const char *raw[MOST_SHOWN]; // whatever else looks like an error
    size_t raw_count;
    size_t open_function; // where the function begins that lacks a }, or 0
    AboutFunction *about;
} Explanation;

// Reads all messages, and drops those that only follow from another.
extern Explanation all;
void explanation_read(const char *source, const char *words);

// The help also calls these.
bool is_semicolon(const Mistake *mistake);
bool is_vector_for_number(const Mistake *mistake);
bool has_comma_in_statement(const Mistake *mistake);

// A line of help (explain_help.c), or "".
const char *help(const Mistake *mistake);

#endif
