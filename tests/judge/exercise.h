// exercise.h - the exercises of tests/exercises.def, with everything that is known about them.
#ifndef TESTS_JUDGE_EXERCISE_H
#define TESTS_JUDGE_EXERCISE_H

#include "tests/judge/types.h"

typedef void AnyFunction(void);

// By value; a pointer to an input; a pointer to an output; a pointer to an image, whose pixels are
// outputs; a pointer to one value for each pixel of the image, which are outputs.
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
    const char *prompt;    // its question
    const char *prototype; // vec3 upper_left(Camera c)
    // The arguments and the results, as words: names of types, in order. Image is a picture with
    // its size, Pixels one with the size of the argument; Doubles are one for each of its pixels.
    const char *arguments, *results;
    const Type *result;
    int parameter_count;
    Parameter parameters[MOST_PARAMETERS];
    // Calls a function of this type. arguments: the address of each, or the pointer itself.
    void (*call)(AnyFunction *function, void *result, void *const *arguments);
    AnyFunction *reference; // NULL if this program does not have it
} Exercise;

// In the list's order; ends with one whose name is NULL. The number of an exercise is its index.
extern const Exercise exercises[];
#define EXERCISE(stem, result, name, ...) NUMBER_##name,
enum {
#include "tests/exercises.def"
    EXERCISE_COUNT
};

// -1 if there is no exercise of this name.
int exercise_number(const char *name);

#endif
