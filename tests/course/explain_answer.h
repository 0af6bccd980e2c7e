// explain_answer.h - the answer that is explained: its lines, its code, and where functions begin.
#ifndef TESTS_COURSE_EXPLAIN_ANSWER_H
#define TESTS_COURSE_EXPLAIN_ANSWER_H

#include "tests/course/explain_text.h"

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

Answer answer_read(const char *source);

const char *answer_text(const Answer *answer, size_t line);
const char *answer_code(const Answer *answer, size_t line);
bool answer_includes(const Answer *answer, const char *header);

// The function whose first line it is, or NULL; the last one of this name.
const OwnFunction *answer_function_at(const Answer *answer, size_t line);
const OwnFunction *answer_function_named(const Answer *answer, const char *name);
// The line in which the function begins to which this line belongs; 0 if there is none.
size_t answer_beginning(const Answer *answer, size_t line);
// Its name, or "".
const char *answer_function_around(const Answer *answer, size_t line);
// The line where a function without its closing } begins; 0 if there is none.
size_t answer_unclosed(const Answer *answer);

// The line in which the statement begins to which this line belongs; and that statement in one
// line.
size_t answer_statement(const Answer *answer, size_t line);
const char *answer_statement_text(const Answer *answer, size_t line);
// The last line with code in it, before this one; or 0.
size_t answer_code_before(const Answer *answer, size_t line);
// How many more ( than ) the statement of this line has.
int answer_brackets(const Answer *answer, size_t line);

// In a for (...); - or if, or while - nothing is left to be done.
bool answer_ends_at_once(const Answer *answer, size_t line);
// The last line up to this one, in its function, with a for that declares the name; or 0.
size_t answer_loop_of(const Answer *answer, const char *name, size_t line);
// Two numbers with a comma between them, and no blank, in the statement of this line: 0,5; or "".
const char *answer_decimal_comma(const Answer *answer, size_t line);

#endif
