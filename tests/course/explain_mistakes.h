// explain_mistakes.h - which mistake each message is about, and which messages are left out.
#ifndef TESTS_COURSE_EXPLAIN_MISTAKES_H
#define TESTS_COURSE_EXPLAIN_MISTAKES_H

#include "tests/course/explain_messages.h"
#include "tests/course/explain_scope.h"

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

typedef struct {
    Code code;
    Diagnostics *diagnostics;
    Mistake *mistakes; // a message each
    size_t count;
    size_t open_function; // where the function begins that lacks a }, or 0
    AboutFunction *about;
} Explanation;

// Reads all messages, and drops those that only follow from another.
Explanation explanation_of(const char *source, const char *words);

// The help also calls these.
bool is_semicolon(const Mistake *mistake);
bool is_vector_for_number(const Mistake *mistake);
bool has_comma_in_statement(const Explanation *all, const Mistake *mistake);

// A line of help, or "".
const char *help(const Explanation *all, const Mistake *mistake);
// Those that are about names, and about types.
const char *help_unknown(const Explanation *all, const Mistake *mistake);
const char *help_signature(const Explanation *all, const Mistake *mistake);
const char *help_types(const Explanation *all, const Mistake *mistake);
const char *help_parts(const Explanation *all, const Mistake *mistake);
const char *help_arrow(const Explanation *all, const Mistake *mistake);
const char *help_member(const Explanation *all, const Mistake *mistake);
const char *help_loop(const Explanation *all, size_t line);
const char *capital(const char *words);

#endif
