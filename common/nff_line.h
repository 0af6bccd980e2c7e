// nff_line.h - a scene file line by line: its words, its numbers, what is wrong with them.
#ifndef COMMON_NFF_LINE_H
#define COMMON_NFF_LINE_H

#include "common/text.h"
#include "common/vec3.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <sys/types.h>

enum { NFF_LONGEST_LINE = 1000, NFF_MOST_WORDS = 16, NFF_HELD = 1 << 16 };

typedef struct {
    FILE *file;
    const char *file_name;
    Message *message;
    int number; // of the current line, from 1
    bool failed;
    int word_count;
    const char *words[NFF_MOST_WORDS]; // of the current line; at least one
    char *next, *end;                  // what is held of the file and not read yet; *end is 0
    int error;                         // errno of a read that failed
    char *held;
    size_t room; // for so many bytes, and zeros
} NffLine;

// False if there is not enough memory. Call nff_end in both cases.
bool nff_begin(NffLine *line, FILE *file, const char *file_name, Message *message);
void nff_end(NffLine *line);

// Holds at least this many bytes from next on, at most NFF_HELD, unless the file ends.
void nff_hold(NffLine *line, size_t size);

// Where next is in a regular file, and reading on from another place there. False if it fails.
off_t nff_tell(const NffLine *line);
bool nff_seek(NffLine *line, off_t start);

// Goes to the next line that has words, comments left out. False at the end of the file, and
// where the file cannot be read; then failed is set.
bool nff_next(NffLine *line);

// Passes over lines of numbers that the toolkit has no use for. False where the file ends before,
// or something else comes.
bool nff_skip(NffLine *line, int lines);

// Says FILE:LINE: and what is wrong. Always false.
bool nff_wrong(NffLine *line, const char *format, ...) __attribute__((format(printf, 2, 3)));

// Reads all words after the first as numbers, from least to most of them. False if one is not a
// number, or there are too few or too many; expected says what the line should have been.
bool nff_numbers(NffLine *line, const char *expected, int least, int most, double *numbers);
bool nff_vec3(NffLine *line, const char *expected, vec3 *v);

#endif
