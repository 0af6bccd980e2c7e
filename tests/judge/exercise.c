// exercise.c - the exercises, made from their list.
#include "tests/judge/exercise.h"

#include "tests/exercises.def" // the contracts
#include "tests/judge/parameters.h"

#include <string.h>

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
