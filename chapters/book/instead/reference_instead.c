// reference_instead.c - the reference (answer_NAME) in the place of one exercise, for a picture.
//
// WANTED_NAME is defined as '~, ~' for the exercise. An answer's own function is weak, so the
// linker takes this one.
#include "tests/judge/parameters.h"

#include "tests/exercises.def" // the contracts

#define IF_WANTED(name, yes, no) IF_VOID_(WANTED_##name, yes, no, ~)

#define NONE(result, name, parameters)
#define BY_REFERENCE(result, name, parameters)                                                     \
    result answer_##name(DECLARED(parameters));                                                    \
    result name(DECLARED(parameters))                                                              \
    {                                                                                              \
        IF_VOID(result, , return ) answer_##name(NAMES(parameters));                               \
    }
#define EXERCISE(stem, result, name, parameters, ...)                                              \
    IF_WANTED(name, BY_REFERENCE, NONE)(result, name, parameters)
#include "tests/exercises.def"
