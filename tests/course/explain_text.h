// explain_text.h - strings of the explainer: made, searched, and freed all at once.
//
// One explanation makes some hundred short strings, which end with it: they all belong to this
// file, and texts_free() frees them. Positions count from 0.
#ifndef TESTS_COURSE_EXPLAIN_TEXT_H
#define TESTS_COURSE_EXPLAIN_TEXT_H

#include <stdbool.h>
#include <stddef.h>

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

// ---- searching ----------------------------------------------------------------------------------

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
const char *text_without(const char *text, const char *pattern);                  // the first match
const char *text_replaced(const char *text, const char *pattern, const char *by); // all of them

// "b.c" of "a + b.c": the expression at the end; "" if there is none.
const char *text_expression_at_end(const char *text);
// The text before the first of this sign, without blanks at its end; "" if the sign is missing.
const char *text_before(const char *text, const char *sign);
// A type without const, struct, static, inline, extern, and blanks around it.
const char *bare_type(const char *type);

#endif
