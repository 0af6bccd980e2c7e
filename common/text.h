// text.h - numbers to words and words to numbers, the same everywhere.
//
// A Text is a short string by value:  printf("%s\n", vec3_text(v).s);
#ifndef COMMON_TEXT_H
#define COMMON_TEXT_H

#include "common/camera.h"
#include "common/screen.h"
#include "common/vec3.h"

#include <stdbool.h>
#include <stdio.h>

typedef struct {
    char s[160];
} Text;

// Significant digits unless told.
#define TEXT_DIGITS 6

// 4, -0.4, 0.166667; never -0. 'not answered yet' where a blank left its mark (answers.h).
Text number_text(double x);
Text number_text_to(double x, int digits);

// (2, 2, -4)
Text vec3_text(vec3 v);
Text vec3_text_to(vec3 v, int digits);

// (0.5, 0.25)
Text pair_text(double x, double y);

// As printf prints it, cut short if it is too long.
Text text_of(const char *format, ...) __attribute__((format(printf, 1, 2)));

// A time in words: 0.0123 ms, 2.34 s, 37.2 s, 3 min 39 s, 2 h 5 min.
Text duration_text(double seconds);

// A word that came from outside, safe to print: cut short, all but plain ASCII as '?'.
Text word_text(const char *word);

// Reads one finite decimal number. Returns what follows it, or NULL where text does not begin
// with one, or where it does not fit a double. No white space, hexadecimals, 'inf' or 'nan'.
const char *read_number(const char *text, double *number);

// A message to hand to the caller, instead of printing it.
typedef struct {
    char text[400];
} Message;

// Always false, for  return message_set(message, "%s:%d: ...", ...);
bool message_set(Message *message, const char *format, ...) __attribute__((format(printf, 2, 3)));

// The text as a string in JSON, in double quotes. It has no control characters but line ends.
void json_print_string(FILE *out, const char *text);

#endif
