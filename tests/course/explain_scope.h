// explain_scope.h - the names, types and letters of the deck that are known in a line of the
// answer.
#ifndef TESTS_COURSE_EXPLAIN_SCOPE_H
#define TESTS_COURSE_EXPLAIN_SCOPE_H

#include "tests/course/explain_answer.h"
#include "tests/course/explain_headers.h"

// The answer, and what it may use.
typedef struct {
    Answer answer;
    Headers headers;
    const char *contract; // exercises/NN-stem.h
} Code;

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

Scope scope_of(const Code *code, size_t line);

bool is_number(const char *type);
bool is_vector_type(const char *type);
const char *with_article(const char *type); // a Camera, an int

// The type of an expression in this line, if it has only names, dots and brackets or can be read
// without a compiler; if not, "".
const char *type_of(const Code *code, const char *expression, size_t line);
const char *type_of_argument(const Code *code, const char *expression, size_t line);
const char *function_type(const Code *code, const char *function);

// How a value of a type is written, or "". A line is not wrapped at its blanks (UNBROKEN).
#define UNBROKEN "\001"
const char *written(const Code *code, const char *type);

// Whether this begins with a declaration: a type, blanks, a name.
bool begins_declaration(const Code *code, const char *text);

// The part of a Camera, Ray, Sphere or Resolution that has this letter on the slides, or "".
const char *part_of_deck(const char *type, const char *letter);
// A letter that nobody declared, by the names of this function: "d is c.distance"; or "". others:
// the letters that mean nothing in it, separated by ", ".
const char *translated(const Code *code, const char *letter, size_t line, const char *others);

// Where in this line a value has a part of this name: "camera.width or view.width", or "". owner:
// their type, "" if there are several.
const char *whole_of(const Code *code, const char *part, size_t line, const char **owner);

#endif
