// slip_text.h - where values and terms begin and end, and how a slip is written down.
#ifndef TESTS_PROOF_GENERATED_SLIP_TEXT_H
#define TESTS_PROOF_GENERATED_SLIP_TEXT_H

#include "tests/proof/generated/slips.h"

// The function that the rest is about, by the numbers of its tokens.
void pen_begin(const Source *of, int function, Slips *into);

const char *text_of(int i);
Kind kind_of(int i);
int closing(int i); // of an opening bracket
bool is(int i, const char *text);
bool is_one_of(int i, const char *words); // " each between blanks "

// Whether a value ends here, so that an operator that follows has two sides.
bool ends_value(int i);
int end_of_primary(int from);
int start_of_primary(int end);
int end_of_term(int from);
int start_of_term(int end);
// One side of && or ||, or one argument; way is 1 or -1.
int end_of_condition(int i, int way);

// Tokens from..to, separated by blanks; valid until a few calls later.
const char *words_of(int from, int to);

// These tokens are replaced by that text.
void slip(int from, int to, const char *format, ...) __attribute__((format(printf, 3, 4)));

// Whether the function has a variable of this name and this type; after find_variables.
void find_variables(int from, int to);
bool is_variable_of(int i, const char *type);

// Slips of statements and of variables.
void statement_slips(int from, int to);

#endif
