// numbers.h - the numbers of a call: of its arguments, or of its results.
//
// So a call crosses to the answering process, and so a table holds it: the values one after the
// other, each as its type says (types.def), a list after the number of its items, pixels as bytes.
// There is no padding, no fourth lane and no byte order. Getting never reads beyond the end: it
// marks the numbers as bad.
#ifndef TESTS_JUDGE_NUMBERS_H
#define TESTS_JUDGE_NUMBERS_H

#include "tests/judge/exercise.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

typedef struct {
    int count, room;
    double *at;      // from malloc
    int read;        // how many of them, so far
    bool bad;        // too few, or invalid
    bool is_hostile; // from a student's process: the conditions of the reference are checked
    bool overran;    // who sent them wrote past the end of an array of the question
} Numbers;

void numbers_add(Numbers *numbers, double x);
void numbers_add_all(Numbers *numbers, const Numbers *others);
void numbers_clear(Numbers *numbers);
void numbers_free(Numbers *numbers);
Numbers numbers_copy(const Numbers *numbers);
bool numbers_make_room(Numbers *numbers, uint64_t count); // false if there is no memory
bool numbers_are_read(const Numbers *numbers);            // to their end, and nothing was invalid
Numbers numbers_again(const Numbers *numbers); // the same ones, to be read from the beginning

// ---- values ------------------------------------------------------------------------------------

// A value of any type. In a value that was got, padding has this byte: nobody should use it, and
// numbers made of it spoil any result. To begin with it is 0xff (NaN).
void numbers_fill_padding_with(int byte);
void numbers_put(Numbers *numbers, const Type *type, const void *value);
void numbers_get(Numbers *numbers, const Type *type, void *value);
void numbers_free_value(const Type *type, void *value); // memory that getting it took from malloc
#define NUMBERS_GET(numbers, type, value) numbers_get(numbers, &type_##type, &(value))

bool is_light_kind(LightKind kind); // and not another number

// Arrays that were got have a guard before their first item and after their last, for loops that
// run once too often. A sphere around the whole world, with a color that no scene has, and a very
// bright light: one item too many shows in the result. The guards of pixels and depths are checked
// afterwards: one item too many that was written shows there, and the guard's depth is farther than
// any hit, so that a hit replaces it.
#define GUARD_SPHERE ((Sphere){{0, 0, 0}, 1e100, 0})
#define GUARD_LIGHT ((Light){{0.48, 0.6, 0.64}, {1, 1, 1}, LIGHT_DISTANT})

void numbers_put_pixels(Numbers *numbers, const Image *image);
void numbers_get_pixels(Numbers *numbers, Image *image); // into an image of the same size
// The memory after the pixels of an image that was got, or after the depths of numbers_get_doubles,
// has changed.
bool pixels_overran(const Image *image);
bool doubles_overran(const double *doubles, const Image *image);

// One per pixel of the image.
void numbers_put_doubles(Numbers *numbers, const double *doubles, const Image *image);
double *numbers_get_doubles(Numbers *numbers, const Image *image);
void numbers_free_doubles(double *doubles); // which numbers_get_doubles has made
void numbers_get_into_doubles(Numbers *numbers, double *doubles, const Image *image);

// ---- the results of an exercise ----------------------------------------------------------------

// Reads as many, as results of these types; marks them as bad if they are none. types: words, as an
// exercise has them (exercise.h).
void numbers_check(Numbers *numbers, const char *types, int count);

// Of types without arrays: how many numbers they are, and the name of the field that each belongs
// to;
// "" if the type has no fields.
enum { MOST_PLACES = 40 };
int layout_names(const char *types, const char *names[MOST_PLACES]);

// Whether the result is a point of a sphere, moved; that point begins at this argument.
enum { STEP_FROM = 5 };
bool layout_is_step(const Exercise *exercise);

// A camera that may be refused for any of several reasons, because the contract leaves the choice
// free: its first number has a bit for each, and one half, which no single reason has.
bool has_reasons(int exercise);                  // whether its result begins with one
int reasons_in(const Numbers *numbers);          // a bit for each, also of a single one
void set_reasons(Numbers *numbers, int reasons); // at least one

// Do two numbers agree? Within the rounding of two ways to compute the same thing. The result of a
// mistake is compared with a student's: NaN agrees with NaN here.
bool same_double(double a, double b);
bool same_within(double a, double b, double tolerance); // 1e-9 is that of same_double
bool numbers_same(const Numbers *a, const Numbers *b);

#endif
