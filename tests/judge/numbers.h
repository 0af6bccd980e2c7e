// numbers.h - what crosses the pipe, as a list of numbers: to write it down, and to compare.
//
// A message is values of known types, one behind the other, as they lie in memory. As numbers it
// is the same on every machine: no padding, no fourth lane, no order of bytes.
#ifndef TESTS_JUDGE_NUMBERS_H
#define TESTS_JUDGE_NUMBERS_H

#include "tests/judge/exercise.h"
#include "tests/judge/wire.h"

typedef struct {
    int count, room;
    double *at; // from malloc
} Numbers;

void numbers_add(Numbers *numbers, double x);
void numbers_free(Numbers *numbers);
Numbers numbers_copy(const Numbers *numbers);
void numbers_of_value(const Type *type, const void *value,
                      Numbers *numbers); // of a flat type, adds

// Whether what comes out is a point of a sphere, moved; that point begins at this argument.
enum { STEP_FROM = 5 };
bool layout_is_step(const Exercise *exercise);

// From a message to numbers and back. types: words, as an exercise has them (exercise.h). size is
// the image's: found among the arguments, needed for the results. False where the message is not of
// these types.
bool layout_read(const char *types, Wire *wire, Resolution *size, Numbers *numbers);
bool layout_write(const char *types, const Numbers *numbers, Resolution *size, Wire *wire);

// Of types that have no arrays: how many numbers they are, and the name of the field that a number
// belongs to; "" where the type has no fields.
int layout_places(const char *types);
const char *layout_place(const char *types, int place);

// As near as rounding leaves two ways to compute the same thing (same.h).
bool numbers_same(const Numbers *a, const Numbers *b);

#endif
