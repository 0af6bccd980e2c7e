// explain_messages.h - the compiler's output: messages about the answer, and the lines after each.
//
// Read from the text that gcc and clang write for people, not from JSON or SARIF: the head of a
// message, FILE:LINE:COLUMN: error: WORDS, and the quote below it have been the same in all
// versions of both, and the quote is shown as it is. gcc's JSON leaves the quote out and goes away
// with gcc 15; SARIF needs gcc 13 or clang 15; clang 14 has neither.
#ifndef TESTS_COURSE_EXPLAIN_MESSAGES_H
#define TESTS_COURSE_EXPLAIN_MESSAGES_H

#include "tests/course/explain_answer.h"

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

enum {
    MOST_SHOWN = 3,
    MOST_READ = 60, // the other messages are only counted
    LONGEST_LINE = 4000
};

typedef struct {
    Message messages[MOST_READ];
    size_t count;
    size_t unread;
    const char *elsewhere;       // an error in another file, or ""
    const char *where_included;  // "FILE:LINE" of the answer, from which that came; or ""
    const char *raw[MOST_SHOWN]; // whatever else looks like an error
    size_t raw_count;
} Diagnostics;

Diagnostics *diagnostics_read(const Answer *answer, const char *words);

// Plain ASCII without colours, typographic quotes, or the type behind vec3.
const char *plain(const char *line);
// The text in single quotes: the first, or the second; "" if there is none.
const char *quoted(const char *text);
const char *quoted_second(const char *text);

#endif
