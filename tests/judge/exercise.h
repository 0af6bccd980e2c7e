// exercise.h - the exercises of tests/exercises.def, with everything that is known about them; and
// the parts of the types that they take and return, for all code that handles values of any type.
#ifndef TESTS_JUDGE_EXERCISE_H
#define TESTS_JUDGE_EXERCISE_H

#include "common/camera.h"
#include "common/image.h"
#include "common/ray.h"
#include "common/scene.h"
#include "common/screen.h"
#include "tests/exercises.def" // the contracts have types of their own

#include <stdbool.h>
#include <stddef.h>

// ---- types -------------------------------------------------------------------------------------

typedef enum { TYPE_OF_NUMBERS, TYPE_OF_WHOLE, TYPE_OF_FIELDS } TypeKind;
typedef enum { FIELD_OF_ONE, FIELD_OF_LIST, FIELD_OF_PIXELS } FieldKind;

typedef struct Type Type;

typedef struct {
    FieldKind kind;
    const char *name;
    const char *label; // in words, with the separator, before the value; NULL: is not shown
    const Type *type;  // of each item
    size_t offset;
    size_t count_at; // of a list: the offset of its int; of pixels: the offset of their Resolution
    bool is_length;  // in the unit of the world: in a world k times as large it is k times as large
} Field;

struct Type {
    const char *name;
    size_t size;
    TypeKind kind;
    int count; // of the doubles, or of the fields
    const Field *fields;
};

// type_Ray and so on: the entries of types.def; and that of functions that return nothing.
#define NUMBERS(type, n) extern const Type type_##type;
#define WHOLE(type) extern const Type type_##type;
#define STRUCT(type, fields) extern const Type type_##type;
#include "tests/judge/types.def"
#undef NUMBERS
#undef WHOLE
#undef STRUCT
extern const Type type_void;

// NULL if no type has this name.
const Type *type_named(const char *name);

// Whether a value contains all of its data: no pointer.
bool type_is_flat(const Type *type);
enum { TYPE_MOST_BYTES = 512 }; // no value is larger

// Whether two numbers differ by at most that; NaN is near nothing.
bool number_near(double yours, double expected, double tolerance);

// Whether two flat values are equal: whole numbers are, lengths are off by at most one of the
// tolerances, other numbers by at most the other.
bool type_near(const Type *type, const void *yours, const void *expected, double tolerance,
               double tolerance_of_lengths);

// A flat value in words: 'origin (0, 0, 0), direction (0, 0, 1)'.
void type_words(const Type *type, const void *value, int digits, char *words, size_t size);

// Calls for each number of a flat value, in order: its address, and whether it is a double; an
// integer has this many bytes. name: of the field; "" if the type has no fields.
typedef void NumberVisitor(void *context, const char *name, void *number, size_t size,
                           bool is_double);
void type_visit(const Type *type, const char *name, void *value, NumberVisitor *visit,
                void *context);

// ---- exercises ---------------------------------------------------------------------------------

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

// ---- for a file that has entries of its own: a Type of each (types.def says what entries are) ---

#ifdef DEFINES_TYPES
#include "tests/judge/parameters.h"

#define NUMBERS(type, n) const Type type_##type = {#type, sizeof(type), TYPE_OF_NUMBERS, n, NULL};
#define WHOLE(type) const Type type_##type = {#type, sizeof(type), TYPE_OF_WHOLE, 1, NULL};
#define STRUCT(type, list)                                                                         \
    static const Field fields_of_##type[] = {EACH(FIELD_IN, COMMA, type, list)};                   \
    const Type type_##type = {#type, sizeof(type), TYPE_OF_FIELDS,                                 \
                              sizeof fields_of_##type / sizeof(Field), fields_of_##type};          \
    _Static_assert(sizeof(type) <= TYPE_MOST_BYTES, "TYPE_MOST_BYTES is too small");

// The kind, the type of an item, the field, its label, the field with the count, is it a length?
#define FIELD(type, field) FIELD_AS(#field " ", type, field)
#define FIELD_AS(label, type, field) (FIELD_OF_ONE, &type_##type, field, label, field, false)
#define LENGTH(type, field) LENGTH_AS(#field " ", type, field)
#define LENGTH_AS(label, type, field) (FIELD_OF_ONE, &type_##type, field, label, field, true)
#define LIST(type, field, count) (FIELD_OF_LIST, &type_##type, field, NULL, count, false)
#define PIXELS(field) (FIELD_OF_PIXELS, NULL, field, NULL, size, false)

#define FIELD_IN(owner, i, field) FIELD_IN_(owner, UNPACK field)
#define FIELD_IN_(...) FIELD_OF(__VA_ARGS__)
#define FIELD_OF(owner, kind, type, field, label, count, is_length)                                \
    {                                                                                              \
        kind, #field, label, type, offsetof(owner, field), offsetof(owner, count), is_length       \
    }
#endif

#endif
