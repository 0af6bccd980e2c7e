// numbers.h - a message as a list of numbers: to record it, and to compare.
//
// A message is a sequence of values of known types, as they are in memory. As numbers it is the
// same on every machine: no padding, no fourth lane, no byte order.
#ifndef TESTS_JUDGE_NUMBERS_H
#define TESTS_JUDGE_NUMBERS_H

#include "tests/judge/exercise.h"
#include "tests/judge/wire.h"

#include <stdbool.h>

typedef struct {
    int count, room;
    double *at; // from malloc
} Numbers;

void numbers_add(Numbers *numbers, double x);
void numbers_free(Numbers *numbers);
Numbers numbers_copy(const Numbers *numbers);

// Whether the result is a point of a sphere, moved; that point begins at this argument.
enum { STEP_FROM = 5 };
bool layout_is_step(const Exercise *exercise);

// From a message to numbers and back. types: words, as an exercise has them (exercise.h). size is
// the image's: found among the arguments, needed for the results. False if the message is not of
// these types.
bool layout_read(const char *types, Wire *wire, Resolution *size, Numbers *numbers);
bool layout_write(const char *types, const Numbers *numbers, Resolution *size, Wire *wire);

// Of types without arrays: how many numbers they are, and the name of the field that a number
// belongs to; "" if the type has no fields.
int layout_places(const char *types);
const char *layout_place(const char *types, int place);

// A camera that may be refused for any of several reasons, because the contract leaves the choice
// free: its first number has a bit for each, and one half, which no single reason has.
bool has_reasons(int exercise);                  // whether its result begins with one
int reasons_in(const Numbers *numbers);          // a bit for each, also of a single one
void set_reasons(Numbers *numbers, int reasons); // at least one

// Equal within the rounding of two ways to compute the same thing.
bool numbers_same(const Numbers *a, const Numbers *b);

// Do two numbers agree? Within the rounding of two ways to compute the same thing.
//
// The result of a mistake is compared with a student's: NaN agrees with NaN here.

bool same_double(double a, double b);
bool same_within(double a, double b, double tolerance); // 1e-9 is that of same_double

#endif
