// exercise.h - the exercises of tests/exercises.def, with all that is known of them.
#ifndef TESTS_JUDGE_EXERCISE_H
#define TESTS_JUDGE_EXERCISE_H

#include "tests/judge/types.h"

typedef void AnyFunction(void);

// By value; a pointer to what is only read; a pointer to what comes back; to an image, whose pixels
// come back; to one value for each pixel of the image, which come back.
typedef enum {
    PASSED_VALUE,
    PASSED_CONST_POINTER,
    PASSED_POINTER,
    PASSED_IMAGE,
    PASSED_PIXELS
} Passing;

enum { MOST_PARAMETERS = 8 };
typedef struct {
    Passing passing;
    const Type *type;
} Parameter;

typedef struct {
    const char *name, *stem;
    const char *slide;     // its title
    const char *prompt;    // what it asks
    const char *prototype; // vec3 upper_left(Camera c)
    // What goes in and what comes out, as words: names of types, in order. Image is a picture with
    // its size, Pixels one of the size that went in; Doubles are one for each of its pixels.
    const char *arguments, *results;
    const Type *result;
    int parameter_count;
    Parameter parameters[MOST_PARAMETERS];
    // Calls a function of this type. arguments: where each is, or what its pointer is.
    void (*call)(AnyFunction *function, void *result, void *const *arguments);
    AnyFunction *reference; // NULL if this program does not have it
} Exercise;

// In the list's order; ends with one whose name is NULL. A number of an exercise is its index.
extern const Exercise exercises[];
#define EXERCISE(stem, result, name, ...) NUMBER_##name,
enum {
#include "tests/exercises.def"
    EXERCISE_COUNT
};

// -1 where there is no exercise of this name.
int exercise_number(const char *name);

#endif
