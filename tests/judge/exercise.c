// exercise.c - the exercises, made from their list, and the parts of a type.
#define DEFINES_TYPES
#include "tests/judge/exercise.h"

#include "tests/exercises.def" // the contracts
#include "tests/judge/parameters.h"

#include <math.h>
#include <string.h>

// ---- types -------------------------------------------------------------------------------------

#include "tests/judge/types.def"
const Type type_void = {"void", 0, TYPE_OF_NUMBERS, 0, NULL};

#undef NUMBERS
#undef WHOLE
#undef STRUCT
#define NUMBERS(type, n) &type_##type,
#define WHOLE(type) &type_##type,
#define STRUCT(type, list) &type_##type,
static const Type *const types[] = {
#include "tests/judge/types.def"
};

const Type *type_named(const char *name)
{
    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++)
        if (strcmp(types[i]->name, name) == 0)
            return types[i];
    return NULL;
}

bool type_is_flat(const Type *type)
{
    bool flat = true;
    for (int i = 0; type->kind == TYPE_OF_FIELDS && i < type->count; i++)
        flat = flat && type->fields[i].kind == FIELD_OF_ONE && type_is_flat(type->fields[i].type);
    return flat;
}

bool number_near(double yours, double expected, double tolerance)
{
    return yours == expected || fabs(yours - expected) <= tolerance;
}

bool type_near(const Type *type, const void *yours, const void *expected, double tolerance,
               double tolerance_of_lengths)
{
    const double *y = yours, *e = expected;
    if (type->kind == TYPE_OF_WHOLE)
        return memcmp(yours, expected, type->size) == 0;
    bool near = true;
    for (int i = 0; near && type->kind == TYPE_OF_NUMBERS && i < type->count; i++)
        near = number_near(y[i], e[i], tolerance);
    for (int i = 0; near && type->kind == TYPE_OF_FIELDS && i < type->count; i++) {
        const Field *field = &type->fields[i];
        near = type_near(field->type, (const char *)yours + field->offset,
                         (const char *)expected + field->offset,
                         field->is_length ? tolerance_of_lengths : tolerance, tolerance_of_lengths);
    }
    return near;
}

void type_visit(const Type *type, const char *name, void *value, NumberVisitor *visit,
                void *context)
{
    if (type->kind == TYPE_OF_NUMBERS)
        for (int i = 0; i < type->count; i++)
            visit(context, name, (double *)value + i, sizeof(double), true);
    else if (type->kind == TYPE_OF_WHOLE)
        visit(context, name, value, type->size, false);
    else
        for (const Field *field = type->fields; field < type->fields + type->count; field++)
            type_visit(field->type, field->name, (char *)value + field->offset, visit, context);
}

// ---- exercises ---------------------------------------------------------------------------------

// The reference is not in every program: weak, so that the linker does not require it.
#define EXERCISE(stem, result, name, parameters, ...)                                              \
    result reference_##name(DECLARED(parameters)) __attribute__((weak));
#include "tests/exercises.def"

#define EXERCISE(stem, result, name, parameters, ...)                                              \
    static void call_##name(AnyFunction *function, void *yours, void *const *arguments)            \
    {                                                                                              \
        (void)yours;                                                                               \
        IF_VOID(result, , *(result *)yours =)                                                      \
        ((result(*)(DECLARED(parameters)))function)(ARGUMENTS(parameters));                        \
    }
#include "tests/exercises.def"

#define PARAMETER(i, passing, type, name)                                                          \
    {                                                                                              \
        PASSED_##passing, &type_##type                                                             \
    }

#define TEXT(i, passing, type, name) TEXT_##passing(#type) #name
#define TEXT_VALUE(type) type " "
#define TEXT_CONST_POINTER(type) "const " type " *"
#define TEXT_POINTER(type) type " *"
#define TEXT_IMAGE TEXT_POINTER
#define TEXT_PIXELS TEXT_POINTER
#define COMMA_TEXT() ", "

// Each begins with a blank, also the first.
#define ARGUMENT_WORD(i, passing, type, name) ARGUMENT_WORD_##passing(" " #type)
#define ARGUMENT_WORD_VALUE(type) type
#define ARGUMENT_WORD_CONST_POINTER(type) type
#define ARGUMENT_WORD_POINTER(type) type
#define ARGUMENT_WORD_IMAGE(type) type
#define ARGUMENT_WORD_PIXELS(type) " Doubles"
#define RESULT_WORD(i, passing, type, name) RESULT_WORD_##passing(" " #type)
#define RESULT_WORD_VALUE(type)
#define RESULT_WORD_CONST_POINTER(type)
#define RESULT_WORD_POINTER(type) type
#define RESULT_WORD_IMAGE(type) " Pixels"
#define RESULT_WORD_PIXELS(type) " Doubles"

#define EXERCISE(stem, result, name, parameters, slide, prompt)                                    \
    {#name,                                                                                        \
     stem,                                                                                         \
     slide,                                                                                        \
     prompt,                                                                                       \
     #result " " #name "(" EACH_PARAMETER(TEXT, COMMA_TEXT, parameters) ")",                       \
     &(EACH_PARAMETER(ARGUMENT_WORD, NOTHING, parameters))[1],                                     \
     &(IF_VOID(result, "", " " #result) EACH_PARAMETER(RESULT_WORD, NOTHING, parameters))[1],      \
     &type_##result,                                                                               \
     sizeof((Parameter[]){EACH_PARAMETER(PARAMETER, COMMA, parameters)}) / sizeof(Parameter),      \
     {EACH_PARAMETER(PARAMETER, COMMA, parameters)},                                               \
     call_##name,                                                                                  \
     (AnyFunction *)reference_##name},
const Exercise exercises[] = {
#include "tests/exercises.def"
    {0},
};

int exercise_number(const char *name)
{
    for (int i = 0; exercises[i].name != NULL; i++)
        if (strcmp(exercises[i].name, name) == 0)
            return i;
    return -1;
}
