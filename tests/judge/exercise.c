// exercise.c - the exercises, made from their list.
#include "tests/judge/exercise.h"

#include "tests/exercises.def" // the contracts
#include "tests/judge/parameters.h"

#include <string.h>

// The reference is not in every program: weak, so that the linker does not require it.
#define EXERCISE(stem, result, name, parameters, ...)                                              \
    result reference_##name(DECLARED(parameters)) __attribute__((weak));
#include "tests/exercises.def"

#define CALL_VALUE(result, name, parameters)                                                       \
    static void call_##name(AnyFunction *function, void *yours, void *const *arguments)            \
    {                                                                                              \
        *(result *)yours = ((result(*)(DECLARED(parameters)))function)(ARGUMENTS(parameters));     \
    }
#define CALL_VOID(result, name, parameters)                                                        \
    static void call_##name(AnyFunction *function, void *yours, void *const *arguments)            \
    {                                                                                              \
        (void)yours;                                                                               \
        ((result(*)(DECLARED(parameters)))function)(ARGUMENTS(parameters));                        \
    }
#define EXERCISE(stem, result, name, parameters, ...)                                              \
    IF_VOID(result, CALL_VOID, CALL_VALUE)(result, name, parameters)
#include "tests/exercises.def"

#define PARAMETER_VALUE(i, type, name)                                                             \
    {                                                                                              \
        PASSED_VALUE, &type_##type                                                                 \
    }
#define PARAMETER_CONST_POINTER(i, type, name)                                                     \
    {                                                                                              \
        PASSED_CONST_POINTER, &type_##type                                                         \
    }
#define PARAMETER_POINTER(i, type, name)                                                           \
    {                                                                                              \
        PASSED_POINTER, &type_##type                                                               \
    }
#define PARAMETER_IMAGE(i, type, name)                                                             \
    {                                                                                              \
        PASSED_IMAGE, &type_##type                                                                 \
    }
#define PARAMETER_PIXELS(i, type, name)                                                            \
    {                                                                                              \
        PASSED_PIXELS, &type_##type                                                                \
    }

#define TEXT_VALUE(i, type, name) #type " " #name
#define TEXT_CONST_POINTER(i, type, name) "const " #type " *" #name
#define TEXT_POINTER(i, type, name) #type " *" #name
#define TEXT_IMAGE(i, type, name) #type " *" #name
#define TEXT_PIXELS(i, type, name) #type " *" #name
#define COMMA_TEXT() ", "

// Each begins with a blank, also the first.
#define ARGUMENT_WORD_VALUE(i, type, name) " " #type
#define ARGUMENT_WORD_CONST_POINTER(i, type, name) " " #type
#define ARGUMENT_WORD_POINTER(i, type, name) " " #type
#define ARGUMENT_WORD_IMAGE(i, type, name) " Image"
#define ARGUMENT_WORD_PIXELS(i, type, name) " Doubles"
#define RESULT_WORD_VALUE(i, type, name)
#define RESULT_WORD_CONST_POINTER(i, type, name)
#define RESULT_WORD_POINTER(i, type, name) " " #type
#define RESULT_WORD_IMAGE(i, type, name) " Pixels"
#define RESULT_WORD_PIXELS(i, type, name) " Doubles"
#define EACH_TEXT(macro, between, parameters) EACH(BY_PASSING, between, macro, parameters)

#define EXERCISE(stem, result, name, parameters, slide, prompt)                                    \
    {#name,                                                                                        \
     stem,                                                                                         \
     slide,                                                                                        \
     prompt,                                                                                       \
     #result " " #name "(" EACH_TEXT(TEXT, COMMA_TEXT, parameters) ")",                            \
     &(EACH_TEXT(ARGUMENT_WORD, NOTHING, parameters))[1],                                          \
     &(IF_VOID(result, "", " " #result) EACH_TEXT(RESULT_WORD, NOTHING, parameters))[1],           \
     &type_##result,                                                                               \
     sizeof((Parameter[]){EACH(BY_PASSING, COMMA, PARAMETER, parameters)}) / sizeof(Parameter),    \
     {EACH(BY_PASSING, COMMA, PARAMETER, parameters)},                                             \
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
