// lent_answers.c - for the answering process: lent_NAME asks the judge for the reference's answer.
//
// If an exercise is lent, the linker puts lent_NAME in the place of its calls.
#include "tests/judge/exercise.h"
#include "tests/judge/message.h"
#include "tests/judge/parameters.h"

#include "tests/exercises.def" // the contracts

#define LENT_VALUE(result, name, parameters)                                                       \
    result lent_##name(DECLARED(parameters));                                                      \
    result lent_##name(DECLARED(parameters))                                                       \
    {                                                                                              \
        result yours;                                                                              \
        transport_call(NUMBER_##name, &yours, (void *[]){ADDRESSES(parameters)});                  \
        return yours;                                                                              \
    }
#define LENT_VOID(result, name, parameters)                                                        \
    result lent_##name(DECLARED(parameters));                                                      \
    result lent_##name(DECLARED(parameters))                                                       \
    {                                                                                              \
        transport_call(NUMBER_##name, NULL, (void *[]){ADDRESSES(parameters)});                    \
    }
#define EXERCISE(stem, result, name, parameters, ...)                                              \
    IF_VOID(result, LENT_VOID, LENT_VALUE)(result, name, parameters)
#include "tests/exercises.def"
